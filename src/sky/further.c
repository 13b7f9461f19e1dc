#include "sky/further.h"

#include "scene/spectrum.h"
#include "sky/gauss_table.h"
#include "sky/harmonics.h"
#include "sky/sky.h"

#include <math.h>
#include <stdio.h>

enum { FURTHER_COLUMNS = 32, FURTHER_ROWS = 32, GATHER_NODES = 8, LAST_NODES = 12, DEFAULT_DEGREE = 10 };

bool further_is_there(const Atmosphere *atmosphere) {
    const double *albedo = atmosphere->ground_albedo;
    return atmosphere->orders > 1 || albedo[0] > 0 || albedo[1] > 0 || albedo[2] > 0;
}

const OrdersPlan *further_plan(const Frame *frame) {
    return orders_plan(frame->further ? frame->further->degree : DEFAULT_DEGREE);
}

void further_slots(SlotList *slots, const Atmosphere *atmosphere) {
    slot_file(slots, "further",
              further_is_there(atmosphere) ? "pass/further.glsl" : "pass/further_none.glsl");
    slot_file(slots, "view-column",
              atmosphere->orders > 1 ? "pass/view_column_kept.glsl" : "sky/view_column_whole.glsl");
}

void further_uniforms(const Frame *frame, Uniforms *uniforms) {
    uniforms_declared_in(uniforms, "pass/view_column_kept.glsl");
    uniforms_float(uniforms, "view_aerosol_kept", orders_kept(&frame->state.atmosphere, further_plan(frame)));
}

void further_key(const Frame *frame, Text *key) {
    if (frame->state.atmosphere.orders > 1) text_append(key, &further_plan(frame)->first_degree, sizeof(int));
}

static bool sky_integrates(const Frame *frame) {
    return frame->sky && frame->sky->method->integrates;
}

/* Moments are wanted as inputs of sky_further only. */
static bool wants_moments(const void *frame) {
    (void)frame;
    return false;
}

/* The air alone. */
static void air_key(const void *data, Text *key) {
    const Frame *frame = data;
    Atmosphere air = frame->state.atmosphere;
    air.observer_height_m = 0;
    for (int c = 0; c < 3; c++) air.sun_irradiance[c] = 1;
    text_append(key, &air, sizeof air);
    further_key(frame, key);
}

static void grid_uniforms(const OrdersPlan *plan, const char *name, Uniforms *uniforms) {
    OrdersColumns columns = orders_columns();
    const struct {
        const char *member;
        double value;
    } members[] = {{"columns", plan->columns},       {"rows", plan->rows},   {"middle", columns.middle},
                   {"closeness", columns.closeness}, {"left", columns.left}, {"right", columns.right}};
    for (int i = 0; i < 6; i++) {
        char full[80];
        snprintf(full, sizeof full, "%s.%s", name, members[i].member);
        uniforms_float(uniforms, full, members[i].value);
    }
}

static void gather_uniforms(const Frame *frame, int nodes, Uniforms *uniforms) {
    const OrdersPlan *plan = further_plan(frame);
    double weights[ORDERS_MOST_DEGREE + 1];
    GaussTable table = gauss_table(nodes);
    orders_weights(&frame->state.atmosphere, plan, weights);
    uniforms_declared_in(uniforms, "pass/orders.glsl");
    grid_uniforms(plan, "order_grid", uniforms);
    uniforms_floats(uniforms, "order_aerosol_weight", weights, ORDERS_MOST_DEGREE + 1);
    uniforms_declared_in(uniforms, "pass/order_nodes.glsl");
    uniforms_int(uniforms, "order_nodes", nodes);
    uniforms_floats(uniforms, "order_gauss.node", table.node, GAUSS_MOST);
    uniforms_floats(uniforms, "order_gauss.weight", table.weight, GAUSS_MOST);
    uniforms_floats(uniforms, "order_gauss.cumulative", table.cumulative, GAUSS_MOST * GAUSS_MOST);
}

/* The quadrature over directions of the field of an order. */
static void direction_uniforms(const OrdersPlan *plan, int order, Uniforms *uniforms) {
    int above = order > 1 ? plan->above : plan->first_above,
        below = order > 1 ? plan->below : plan->first_below;
    double count[3] = {above, below, order > 1 ? plan->azimuths : plan->first_azimuths};
    double node[ORDERS_MOST_ELEVATIONS] = {0}, weight[ORDERS_MOST_ELEVATIONS] = {0};
    gauss_nodes(above, node, weight);
    gauss_nodes(below, node + above, weight + above);
    uniforms_declared_in(uniforms, "pass/order_directions.glsl");
    uniforms_vec3(uniforms, "order_directions", count);
    uniforms_floats(uniforms, "order_elevation", node, ORDERS_MOST_ELEVATIONS);
    uniforms_floats(uniforms, "order_elevation_weight", weight, ORDERS_MOST_ELEVATIONS);
}

static int degree_of(const OrdersPlan *plan, int order) {
    return order > 1 ? plan->degree : plan->first_degree;
}

static int direction_count(const OrdersPlan *plan, int order) {
    return order > 1 ? (plan->above + plan->below) * plan->azimuths
                     : (plan->first_above + plan->first_below) * plan->first_azimuths;
}

/* The light of an order's field. */

static void light_size(const Frame *frame, int order, int *width, int *height) {
    const OrdersPlan *plan = further_plan(frame);
    *width = direction_count(plan, order);
    *height = plan->rows * plan->columns * spectrum_bands(&frame->state.atmosphere);
}

static void light_uniforms(const Frame *frame, int order, Uniforms *uniforms) {
    const OrdersPlan *plan = further_plan(frame);
    gather_uniforms(frame, GATHER_NODES, uniforms);
    direction_uniforms(plan, order, uniforms);
    if (order == 1) return;
    uniforms_declared_in(uniforms, "pass/fill_order_next.glsl");
    uniforms_int(uniforms, "order_before_degree", degree_of(plan, order - 1));
    uniforms_int(uniforms, "order_most", plan->degree);
}

/* The moments of an order's field. */

static void moments_size(const Frame *frame, int degree, int *width, int *height) {
    const OrdersPlan *plan = further_plan(frame);
    *width = plan->columns;
    *height = plan->rows * (harmonics_count(degree) + 1) * spectrum_bands(&frame->state.atmosphere);
}

static void moments_uniforms(const Frame *frame, int order, Uniforms *uniforms) {
    const OrdersPlan *plan = further_plan(frame);
    uniforms_declared_in(uniforms, "pass/fill_order_moments.glsl");
    grid_uniforms(plan, "moments_grid", uniforms);
    uniforms_int(uniforms, "moments_degree", degree_of(plan, order));
    uniforms_int(uniforms, "moments_directions", direction_count(plan, order));
}

/* The kinds' functions know their order by their names. */
#define FIELD(order)                                                                                         \
    static void light_size_##order(const void *frame, int *width, int *height) {                             \
        light_size(frame, order, width, height);                                                             \
    }                                                                                                        \
    static void light_uniforms_##order(const Resource *light, const void *frame, Uniforms *uniforms) {       \
        (void)light;                                                                                         \
        light_uniforms(frame, order, uniforms);                                                              \
    }                                                                                                        \
    static void moments_size_##order(const void *frame, int *width, int *height) {                           \
        moments_size(frame, degree_of(further_plan(frame), order), width, height);                           \
    }                                                                                                        \
    static void moments_uniforms_##order(const Resource *moments, const void *frame, Uniforms *uniforms) {   \
        (void)moments;                                                                                       \
        moments_uniforms(frame, order, uniforms);                                                            \
    }

FIELD(1)
FIELD(2)
FIELD(3)
FIELD(4)

#define LIGHT(order, file, ...)                                                                              \
    {                                                                                                        \
        .name = "the light of order " #order, .entry = file,                                                 \
        .samplers = {"order_" #order "_light", "order_" #order "_angles"}, .filter = GL_NEAREST,             \
        .wanted = wants_moments, .in_steps = true, .size = light_size_##order,                               \
        .uniforms = light_uniforms_##order, __VA_ARGS__                                                      \
    }

#define NEXT(order)                                                                                          \
    LIGHT(order, "pass/fill_order_next.glsl", .inputs = {&order_moments[order - 2]},                         \
          .input_samplers = {{"order_before"}})

#define MOMENTS(order)                                                                                       \
    {                                                                                                        \
        .name = "the moments of order " #order, .entry = "pass/fill_order_moments.glsl",                     \
        .samplers = {"order_" #order "_moments"}, .filter = GL_NEAREST, .inputs = {&order_light[order - 1]}, \
        .input_samplers = {{"order_light", "order_angles"}}, .wanted = wants_moments, .in_steps = true,      \
        .size = moments_size_##order, .uniforms = moments_uniforms_##order                                   \
    }

const ResourceKind order_light[ORDER_FIELDS] = {LIGHT(1, "pass/fill_order_first.glsl", .key = air_key),
                                                NEXT(2), NEXT(3), NEXT(4)};

const ResourceKind order_moments[ORDER_FIELDS] = {MOMENTS(1), MOMENTS(2), MOMENTS(3), MOMENTS(4)};

/* The sum of the orders. */

static void sum_size(const void *frame, int *width, int *height) {
    moments_size(frame, further_plan(frame)->first_degree, width, height);
}

/* `orders` counts those that are seen: the field of order k is seen as order k + 1. */
static void sum_uniforms(const Resource *sum, const void *data, Uniforms *uniforms) {
    const Frame *frame = data;
    const OrdersPlan *plan = further_plan(frame);
    double orders = frame->state.atmosphere.orders;
    double counts[4] = {orders > 2, orders > 3, orders > 4, isinf(orders) ? -1 : fmax(orders - 5, 0)};
    (void)sum;
    uniforms_declared_in(uniforms, "pass/fill_order_sum.glsl");
    grid_uniforms(plan, "sum_grid", uniforms);
    uniforms_int(uniforms, "sum_first_degree", plan->first_degree);
    uniforms_int(uniforms, "sum_degree", plan->degree);
    uniforms_vec4(uniforms, "sum_orders", counts);
}

const ResourceKind sky_moments = {
    .name = "the moments of all orders",
    .entry = "pass/fill_order_sum.glsl",
    .samplers = {"sky_moments"},
    .filter = GL_LINEAR,
    .inputs = {&order_moments[0], &order_moments[1], &order_moments[2], &order_moments[3]},
    .wanted = wants_moments,
    .in_steps = true,
    .size = sum_size,
    .uniforms = sum_uniforms};

/* The further light by direction. */

static bool wants_further(const void *data) {
    const Frame *frame = data;
    return sky_integrates(frame) && frame->state.atmosphere.orders > 1;
}

static bool wants_ground(const void *data) {
    const Frame *frame = data;
    const Atmosphere *a = &frame->state.atmosphere;
    return sky_integrates(frame) && a->orders <= 1 && further_is_there(a);
}

static void further_size(const void *frame, int *width, int *height) {
    (void)frame;
    *width = FURTHER_COLUMNS;
    *height = 2 * FURTHER_ROWS;
}

static void table_uniforms(const Frame *frame, Uniforms *uniforms) {
    static const double size[3] = {FURTHER_COLUMNS, FURTHER_ROWS, 0};
    uniforms_declared_in(uniforms, "pass/further_size.glsl");
    uniforms_vec3(uniforms, "further_size", size);
    uniforms_float(uniforms, "further_horizon", sky_horizon_sine(&frame->state.atmosphere));
    uniforms_float(uniforms, "further_limb", sky_limb_sine(&frame->state.atmosphere));
    gather_uniforms(frame, LAST_NODES, uniforms);
}

static void last_uniforms(const Resource *table, const void *frame, Uniforms *uniforms) {
    (void)table;
    table_uniforms(frame, uniforms);
    uniforms_declared_in(uniforms, "pass/fill_further.glsl");
    uniforms_int(uniforms, "sky_moments_degree", further_plan(frame)->first_degree);
}

static void ground_uniforms(const Resource *table, const void *frame, Uniforms *uniforms) {
    (void)table;
    table_uniforms(frame, uniforms);
}

const ResourceKind sky_further = {.name = "the further light",
                                  .entry = "pass/fill_further.glsl",
                                  .samplers = {"further_table"},
                                  .filter = GL_LINEAR,
                                  .inputs = {&sky_moments},
                                  .wanted = wants_further,
                                  .size = further_size,
                                  .key = sky_key,
                                  .uniforms = last_uniforms};

const ResourceKind sky_ground = {.name = "the ground's light",
                                 .entry = "pass/fill_ground.glsl",
                                 .samplers = {"further_table"},
                                 .filter = GL_LINEAR,
                                 .wanted = wants_ground,
                                 .size = further_size,
                                 .key = sky_key,
                                 .uniforms = ground_uniforms};
