#include "sky/orders.h"

#include "scene/spectrum.h"
#include "sky/gauss_table.h"
#include "sky/harmonics.h"

#include <math.h>
#include <stdio.h>

enum { RAY_NODES = 8, DEFAULT_DEGREE = 10 };

const OrdersPlan *orders_plan_of(const Frame *frame) {
    return orders_plan(frame->further ? frame->further->degree : DEFAULT_DEGREE);
}

void orders_key(const Frame *frame, Text *key) {
    int most = orders_plan_of(frame)->orders[0].degree;
    if (frame->state.atmosphere.orders > 1) text_append(key, &most, sizeof most);
}

/* All tables here are inputs of the further light, and wanted only as such. */
static bool wants_none(const void *frame) {
    (void)frame;
    return false;
}

/* The tables depend on the air and the ground. The observer and the sun's irradiance have no influence. */
static void air_key(const void *data, Text *key) {
    const Frame *frame = data;
    Atmosphere air = frame->state.atmosphere;
    air.observer_height_m = 0;
    for (int c = 0; c < 3; c++) air.sun_irradiance[c] = 1;
    text_append(key, &air, sizeof air);
    orders_key(frame, key);
}

static void grid_uniforms(const OrdersPlan *plan, const char *name, Uniforms *uniforms) {
    OrdersColumns columns = orders_columns();
    const struct {
        const char *member;
        double value;
    } members[] = {{"columns", plan->columns},       {"rows", plan->rows},   {"middle", columns.middle},
                   {"closeness", columns.closeness}, {"left", columns.left}, {"right", columns.right}};
    for (size_t i = 0; i < sizeof members / sizeof *members; i++) {
        char full[80];
        snprintf(full, sizeof full, "%s.%s", name, members[i].member);
        uniforms_float(uniforms, full, members[i].value);
    }
}

void orders_gather_uniforms(const Frame *frame, int nodes, Uniforms *uniforms) {
    const OrdersPlan *plan = orders_plan_of(frame);
    double weights[ORDERS_MOST_DEGREE + 1];
    orders_weights(&frame->state.atmosphere, plan, weights);
    uniforms_declared_in(uniforms, "pass/orders.glsl");
    grid_uniforms(plan, "order_grid", uniforms);
    uniforms_floats(uniforms, "order_aerosol_weight", weights, ORDERS_MOST_DEGREE + 1);
    uniforms_int(uniforms, "rays_nodes", nodes);
}

void orders_ray_uniforms(int nodes, Uniforms *uniforms) {
    GaussTable table = gauss_table(nodes);
    uniforms_declared_in(uniforms, "pass/rays.glsl");
    uniforms_int(uniforms, "ray_nodes", nodes);
    uniforms_floats(uniforms, "ray_node", table.node, GAUSS_MOST);
    uniforms_floats(uniforms, "ray_weight", table.weight, GAUSS_MOST);
    uniforms_floats(uniforms, "ray_cumulative", table.cumulative, GAUSS_MOST * GAUSS_MOST);
}

/* The quadrature over directions of an order's field. */
static void direction_uniforms(const OrderPlan *order, Uniforms *uniforms) {
    double count[3] = {order->above, order->below, order->azimuths};
    double node[ORDERS_MOST_ELEVATIONS] = {0}, weight[ORDERS_MOST_ELEVATIONS] = {0};
    gauss_nodes(order->above, node, weight);
    gauss_nodes(order->below, node + order->above, weight + order->above);
    uniforms_declared_in(uniforms, "pass/order_directions.glsl");
    uniforms_vec3(uniforms, "order_directions", count);
    uniforms_floats(uniforms, "order_elevation", node, ORDERS_MOST_ELEVATIONS);
    uniforms_floats(uniforms, "order_elevation_weight", weight, ORDERS_MOST_ELEVATIONS);
}

static void rays_size(const Frame *frame, int k, int *width, int *height) {
    const OrdersPlan *plan = orders_plan_of(frame);
    *width = (plan->orders[k].above + plan->orders[k].below) * (2 * RAY_NODES + 1);
    *height = plan->rows * spectrum_bands(&frame->state.atmosphere);
}

static void rays_uniforms(const Frame *frame, int k, Uniforms *uniforms) {
    const OrdersPlan *plan = orders_plan_of(frame);
    orders_ray_uniforms(RAY_NODES, uniforms);
    direction_uniforms(&plan->orders[k], uniforms);
    uniforms_declared_in(uniforms, "pass/fill_order_rays.glsl");
    grid_uniforms(plan, "ray_grid", uniforms);
}

static void light_size(const Frame *frame, int k, int *width, int *height) {
    const OrdersPlan *plan = orders_plan_of(frame);
    *width = order_directions(&plan->orders[k]);
    *height = plan->rows * plan->columns * spectrum_bands(&frame->state.atmosphere);
}

static void light_uniforms(const Frame *frame, int k, Uniforms *uniforms) {
    const OrdersPlan *plan = orders_plan_of(frame);
    orders_gather_uniforms(frame, RAY_NODES, uniforms);
    direction_uniforms(&plan->orders[k], uniforms);
    if (k) {
        uniforms_declared_in(uniforms, "pass/fill_order_next.glsl");
        uniforms_int(uniforms, "order_before_degree", plan->orders[k - 1].degree);
        uniforms_int(uniforms, "order_most", plan->orders[k].degree);
        return;
    }
    GaussTable table = gauss_table(RAY_NODES);
    uniforms_declared_in(uniforms, "pass/order_nodes.glsl");
    uniforms_int(uniforms, "order_nodes", RAY_NODES);
    uniforms_floats(uniforms, "order_gauss.node", table.node, RAY_NODES);
    uniforms_floats(uniforms, "order_gauss.weight", table.weight, RAY_NODES);
    uniforms_floats(uniforms, "order_gauss.cumulative", table.cumulative, RAY_NODES * RAY_NODES);
}

static void moments_size(const Frame *frame, int k, int *width, int *height) {
    const OrdersPlan *plan = orders_plan_of(frame);
    *width = plan->columns;
    *height =
        plan->rows * (harmonics_count(plan->orders[k].degree) + 1) * spectrum_bands(&frame->state.atmosphere);
}

static void moments_uniforms(const Frame *frame, int k, Uniforms *uniforms) {
    const OrdersPlan *plan = orders_plan_of(frame);
    uniforms_declared_in(uniforms, "pass/fill_order_moments.glsl");
    grid_uniforms(plan, "moments_grid", uniforms);
    uniforms_int(uniforms, "moments_degree", plan->orders[k].degree);
    uniforms_int(uniforms, "moments_directions", order_directions(&plan->orders[k]));
}

/* A kind's functions are not told for which kind they are called. Therefore each kind has functions of its
 * own. */
#define FUNCTIONS(what, k)                                                                                   \
    static void what##_size_##k(const void *frame, int *width, int *height) {                                \
        what##_size(frame, k, width, height);                                                                \
    }                                                                                                        \
    static void what##_uniforms_##k(const Resource *table, const void *frame, Uniforms *uniforms) {          \
        (void)table;                                                                                         \
        what##_uniforms(frame, k, uniforms);                                                                 \
    }

FUNCTIONS(rays, 0)
FUNCTIONS(rays, 1)
FUNCTIONS(rays, 2)
FUNCTIONS(rays, 3)
FUNCTIONS(rays, 4)
FUNCTIONS(light, 0)
FUNCTIONS(light, 1)
FUNCTIONS(light, 2)
FUNCTIONS(light, 3)
FUNCTIONS(light, 4)
FUNCTIONS(moments, 0)
FUNCTIONS(moments, 1)
FUNCTIONS(moments, 2)
FUNCTIONS(moments, 3)
FUNCTIONS(moments, 4)

/* Its inputs do not follow the sun, so that it is finished even while the sun moves. */
static bool always(const void *frame) {
    (void)frame;
    return true;
}

#define COMMON(what, k)                                                                                      \
    .filter = GL_NEAREST, .wanted = wants_none, .in_steps = always, .size = what##_size_##k,                 \
    .uniforms = what##_uniforms_##k

#define RAYS(k, number)                                                                                      \
    {                                                                                                        \
        .name = "the rays of order " number, .entry = "pass/fill_order_rays.glsl", COMMON(rays, k),          \
        .samplers = {"order_" number "_rays_air", "order_" number "_rays_aerosols"}, .key = air_key          \
    }

#define LIGHT(k, number, ...)                                                                                \
    {                                                                                                        \
        .name = "the light of order " number, COMMON(light, k),                                              \
        .samplers = {"order_" number "_light", "order_" number "_angles"}, __VA_ARGS__                       \
    }

#define NEXT(k, number)                                                                                      \
    LIGHT(k, number, .entry = "pass/fill_order_next.glsl",                                                   \
          .inputs = {&order_rays[k], &order_moments[k - 1]},                                                 \
          .input_samplers = {{"rays_air", "rays_aerosols"}, {"order_before"}})

#define MOMENTS(k, number)                                                                                   \
    {                                                                                                        \
        .name = "the moments of order " number, .entry = "pass/fill_order_moments.glsl", COMMON(moments, k), \
        .samplers = {"order_" number "_moments"}, .inputs = {&order_light[k]}, .input_samplers = {           \
            {"order_light", "order_angles"}                                                                  \
        }                                                                                                    \
    }

const ResourceKind order_rays[ORDER_FIELDS] = {RAYS(0, "1"), RAYS(1, "2"), RAYS(2, "3"), RAYS(3, "4"),
                                               RAYS(4, "5")};

const ResourceKind order_light[ORDER_FIELDS] = {LIGHT(0, "1", .entry = "pass/fill_order_first.glsl",
                                                      .inputs = {&order_rays[0]},
                                                      .input_samplers = {{"rays_air", "rays_aerosols"}}),
                                                NEXT(1, "2"), NEXT(2, "3"), NEXT(3, "4"), NEXT(4, "5")};

const ResourceKind order_moments[ORDER_FIELDS] = {MOMENTS(0, "1"), MOMENTS(1, "2"), MOMENTS(2, "3"),
                                                  MOMENTS(3, "4"), MOMENTS(4, "5")};

static void sum_size(const void *frame, int *width, int *height) {
    moments_size(frame, 0, width, height);
}

/* The field of order k is seen by the light that it scatters, which has the order k + 1. So of N orders the
 * fields up to N - 1 count. Field 1 always does, because this table is filled for 2 orders or more. */
static void sum_uniforms(const Resource *sum, const void *data, Uniforms *uniforms) {
    const Frame *frame = data;
    const OrdersPlan *plan = orders_plan_of(frame);
    double orders = frame->state.atmosphere.orders, degrees[ORDER_FIELDS], counts[ORDER_FIELDS];
    (void)sum;
    for (int k = 0; k < ORDER_FIELDS; k++) {
        degrees[k] = plan->orders[k].degree;
        counts[k] = orders > k + 1;
    }
    uniforms_declared_in(uniforms, "pass/fill_order_sum.glsl");
    grid_uniforms(plan, "sum_grid", uniforms);
    uniforms_floats(uniforms, "sum_degrees", degrees, ORDER_FIELDS);
    uniforms_floats(uniforms, "sum_counts", counts, ORDER_FIELDS);
    uniforms_float(uniforms, "sum_following", isinf(orders) ? -1 : fmax(orders - ORDER_FIELDS - 1, 0));
}

const ResourceKind sky_moments = {
    .name = "the moments of all orders",
    .entry = "pass/fill_order_sum.glsl",
    .samplers = {"sky_moments"},
    .filter = GL_NEAREST,
    .inputs = {&order_moments[0], &order_moments[1], &order_moments[2], &order_moments[3], &order_moments[4]},
    .wanted = wants_none,
    .in_steps = always,
    .size = sum_size,
    .uniforms = sum_uniforms};
