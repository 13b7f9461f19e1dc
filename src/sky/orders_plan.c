#include "sky/orders_plan.h"

#include "base/vec3.h"
#include "sky/harmonics.h"

#include <math.h>

static const OrdersPlan plans[] = {
    {64, 16, 8, 4, 14, 6, 14, 6, 3, 6, 4},
    {64, 16, 10, 6, 14, 6, 14, 8, 4, 8, 4},
    {64, 16, 14, 8, 14, 6, 14, 10, 5, 8, 4},
};

const OrdersPlan *orders_plan(int first_degree) {
    for (int i = 0; i < (int)(sizeof plans / sizeof *plans); i++) {
        if (plans[i].first_degree == first_degree) return &plans[i];
    }
    return NULL;
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

/* The Legendre coefficient three degrees above those that are kept: measured as the best over the sky. A
 * peak that points backward cannot be taken as light that goes on. */
double orders_peak(const Atmosphere *atmosphere, const OrdersPlan *plan) {
    double chi[ORDERS_MOST_DEGREE + 4];
    if (atmosphere->orders < 2) return 0;
    harmonics_mie(atmosphere->mie_g, plan->first_degree + 3, chi);
    return atmosphere->mie_g > 0 ? chi[plan->first_degree + 3] : 0;
}

double orders_kept(const Atmosphere *atmosphere, const OrdersPlan *plan) {
    return 1 - orders_peak(atmosphere, plan) / atmosphere->mie_extinction_ratio;
}

void orders_weights(const Atmosphere *atmosphere, const OrdersPlan *plan,
                    double weights[ORDERS_MOST_DEGREE + 1]) {
    double peak = orders_peak(atmosphere, plan);
    for (int l = 0; l <= ORDERS_MOST_DEGREE; l++) weights[l] = 0;
    harmonics_mie(atmosphere->mie_g, plan->first_degree, weights);
    for (int l = 0; l <= plan->first_degree; l++) weights[l] -= peak;
}
