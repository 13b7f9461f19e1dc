#include "sky/sky_orders.h"

#include "base/memory.h"
#include "base/vec3.h"
#include "sky/orders_step.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Its errors are 0.03 % RMS by day, 0.06 % in twilight and 0.3 % below -6 degrees, with
 * tests/data/sky_multiple.csv as the truth. All of the peak is computed, because the exact single scattering
 * goes with it: to the degree 20 of g = 0.76 it is as accurate as without. */
const SkyOrdersPlan sky_orders_plan = {.rows = 22,
                                       .columns = 80,
                                       .points = 4,
                                       .nodes = 10,
                                       .last_nodes = 24,
                                       .orders = 7,
                                       .order = {{20, 12, 16, 8, 14},
                                                 {12, 10, 10, 5, 10},
                                                 {10, 8, 8, 4, 8},
                                                 {8, 8, 8, 4, 8},
                                                 {8, 8, 8, 4, 8},
                                                 {8, 8, 8, 4, 8},
                                                 {8, 8, 8, 4, 8}}};

struct SkyOrders {
    OrdersAir air;
    OrdersGrid grid;
    SkyOrdersPlan plan;
    /* Those of the plan, of the last gathering, and of the first order that is seen. */
    OrdersGauss gauss, gauss_last, gauss_first;
    /* All fields together, packed. The ground sees the sun besides. */
    OrdersField sum;
    HarmonicStep steps[HARMONICS_MOST];
};

/* The field of an order, counted from 0, from the one before. Order 1 takes about half of the time. */
static bool compute(const SkyOrders *o, int order, const OrdersField *before, const SkyWatch *watch,
                    OrdersField *field) {
    OrdersField packed = {0};
    OrdersStep step = {.air = &o->air,
                       .grid = &o->grid,
                       .gauss = &o->gauss,
                       .plan = &o->plan.order[order],
                       .watch = watch,
                       .from = 1 - pow(0.5, order),
                       .to = 1 - pow(0.5, order + 1)};
    if (order > 0) {
        packed = orders_field_pack(&o->grid, before, o->plan.order[order - 1].onward);
        step.before = &packed;
    }
    bool go_on = orders_step(&step, field);
    orders_field_free(&packed);
    return go_on;
}

/* Light of an order is seen as the order after, when it has been gathered: fields up to order N - 1 make the
 * light of N orders. */
static bool solve(SkyOrders *o, const SkyWatch *watch) {
    double wanted = o->air.atmosphere.orders - 1;
    OrdersField sum = orders_field_create(&o->grid, o->plan.order[0].degree), before = {0};
    bool go_on = true;
    for (int order = 0; go_on && order < o->plan.orders && order < wanted; order++) {
        OrdersField field;
        bool last = order > 0 && order == o->plan.orders - 1;
        go_on = compute(o, order, &before, watch, &field);
        orders_field_add(&o->grid, &sum, &field, last ? &before : NULL, wanted - order - 1);
        orders_field_free(&before);
        before = field;
    }
    o->sum = orders_field_pack(&o->grid, &sum, sum.degree);
    orders_field_free(&before);
    orders_field_free(&sum);
    return go_on;
}

SkyOrders *sky_orders_create(const Atmosphere *atmosphere, const SkyOrdersPlan *plan, const SkyWatch *watch) {
    int most = plan->order[0].degree;
    SkyOrders *o = memory_get(1, sizeof *o);
    *o = (SkyOrders){.air = orders_air(atmosphere, most, plan->peak && atmosphere->orders > 1),
                     .grid = {.rows = plan->rows,
                              .columns = plan->columns,
                              .points = plan->points,
                              .top_m = air_top_height(atmosphere),
                              .across = orders_columns()},
                     .plan = *plan,
                     .gauss = orders_gauss(plan->nodes),
                     .gauss_last = orders_gauss(plan->last_nodes),
                     .gauss_first = orders_gauss(plan->last_nodes < 26 ? plan->last_nodes : 26)};
    harmonics_steps(most, o->steps);
    if (atmosphere->orders <= 1 || solve(o, watch)) return o;
    sky_orders_destroy(o);
    return NULL;
}

void sky_orders_destroy(SkyOrders *o) {
    if (!o) return;
    orders_field_free(&o->sum);
    free(o);
}

static void gather_node(const SkyOrders *o, const OrdersAim *aim, const OrdersRay *ray, double sun_rise,
                        const OrdersNode *node, double radiance[3]) {
    OrdersCorner corners[16];
    OrdersPlace row = orders_grid_row(&o->grid, node->height);
    OrdersPlace column = orders_grid_column(&o->grid, (sun_rise + aim->nu * node->t) / node->radius);
    int points = o->grid.points;
    for (int i = 0; i < points * points; i++) {
        int along = i / points, across = i % points;
        corners[i] =
            (OrdersCorner){orders_field_at(&o->grid, &o->sum, row.first + along, column.first + across),
                           row.weights[along] * column.weights[across]};
    }
    orders_scatter(aim, corners, points * points, ray->path.rise, sun_rise, node, radiance);
}

void sky_orders_radiance(const SkyOrders *o, double height_m, const double view[3], const double sun[3],
                         double radiance[3]) {
    double v[3], s[3];
    OrdersRay ray;
    OrdersAim aim;
    memset(radiance, 0, 3 * sizeof *radiance);
    if (!o->sum.moments) return;
    vec3_normalize(view, v);
    vec3_normalize(sun, s);
    orders_ray(&o->air, height_m, v[1], &o->gauss_last, NULL, 0, &ray);
    orders_aim(&o->air, o->steps, o->sum.degree, vec3_dot(v, s), &aim);
    double sun_rise = (o->air.atmosphere.planet_radius_m + height_m) * s[1] + aim.nu * ray.start;
    for (int i = 0; i < ray.count; i++) gather_node(o, &aim, &ray, sun_rise, &ray.nodes[i], radiance);
    orders_field_ground(&o->grid, &o->sum, &o->air, &ray, sun_rise, aim.nu, radiance);
}

void sky_orders_first(const SkyOrders *o, double height_m, const double view[3], const double sun[3],
                      double radiance[3]) {
    double v[3], s[3];
    vec3_normalize(view, v);
    vec3_normalize(sun, s);
    orders_air_first(&o->air, height_m, v[1], s[1], vec3_dot(v, s), &o->gauss_first, radiance);
}
