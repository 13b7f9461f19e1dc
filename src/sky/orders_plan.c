#include "sky/orders_plan.h"

#include "base/vec3.h"
#include "sky/harmonics.h"

#include <math.h>

/* A field is smoother than the one before it, and needs fewer harmonics and directions. Order 1 has the
 * aureole about the sun and a sharp horizon, and needs most. glsl/sky/README.md has the errors of each
 * quality. */
static const OrdersPlan plans[] = {
    {64, 16, {{8, 14, 5, 12}, {4, 6, 3, 6}, {4, 6, 3, 6}, {4, 6, 3, 6}, {4, 6, 3, 6}}},
    {64, 16, {{10, 14, 5, 12}, {6, 8, 4, 8}, {4, 6, 3, 6}, {4, 6, 3, 6}, {4, 6, 3, 6}}},
    {64, 16, {{14, 14, 5, 12}, {8, 10, 5, 8}, {6, 8, 4, 8}, {6, 8, 4, 8}, {4, 6, 3, 6}}},
};

const OrdersPlan *orders_plan(int most) {
    for (int i = 0; i < (int)(sizeof plans / sizeof *plans); i++) {
        if (plans[i].orders[0].degree == most) return &plans[i];
    }
    return NULL;
}

int order_directions(const OrderPlan *order) {
    return (order->above + order->below) * order->azimuths;
}

static double chord(double sine) {
    return sqrt(fmax(2 * (1 - sine), 0));
}

OrdersColumns orders_columns(void) {
    static const double middle_deg = -3, width_deg = 8, lowest_deg = -20;
    OrdersColumns columns = {.middle = chord(sin(middle_deg * degree)),
                             .closeness = 1 / (cos((90 - middle_deg) / 2 * degree) * width_deg * degree)};
    columns.left = asinh((columns.middle - chord(sin(lowest_deg * degree))) * columns.closeness);
    columns.right = asinh(columns.middle * columns.closeness);
    return columns;
}

/* The Legendre coefficient three degrees above those that are kept, which was the best of those measured over
 * the sky. The usual choice is the coefficient one degree above (Wiscombe 1977), which was far too large:
 * with degree 4 it was worse than no peak at all. If g is negative the peak points backward, and cannot count
 * as light that goes on. */
double orders_peak(const Atmosphere *atmosphere, const OrdersPlan *plan) {
    double chi[ORDERS_MOST_DEGREE + 4];
    int beyond = plan->orders[0].degree + 3;
    if (atmosphere->orders < 2 || atmosphere->mie_g <= 0) return 0;
    harmonics_mie(atmosphere->mie_g, beyond, chi);
    return chi[beyond];
}

double orders_kept(const Atmosphere *atmosphere, const OrdersPlan *plan) {
    return 1 - orders_peak(atmosphere, plan) / atmosphere->mie_extinction_ratio;
}

void orders_weights(const Atmosphere *atmosphere, const OrdersPlan *plan,
                    double weights[ORDERS_MOST_DEGREE + 1]) {
    int most = plan->orders[0].degree;
    double peak = orders_peak(atmosphere, plan);
    for (int l = 0; l <= ORDERS_MOST_DEGREE; l++) weights[l] = 0;
    harmonics_mie(atmosphere->mie_g, most, weights);
    for (int l = 0; l <= most; l++) weights[l] -= peak;
}
