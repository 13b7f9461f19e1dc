#include "sky/further.h"

#include "scene/spectrum.h"
#include "sky/observer.h"

#include <math.h>

/* The columns of a preview are enough for light that is smooth around the horizon. */
enum { TABLE_COLUMNS = 32, PREVIEW_COLUMNS = 8, TABLE_ROWS = 32, TABLE_BELOW = 64, RAY_NODES = 8 };

bool further_is_there(const Atmosphere *atmosphere) {
    const double *albedo = atmosphere->ground_albedo;
    return atmosphere->orders > 1 || albedo[0] > 0 || albedo[1] > 0 || albedo[2] > 0;
}

void further_slots(SlotList *slots, const Atmosphere *atmosphere) {
    slot_file(slots, "further",
              further_is_there(atmosphere) ? "pass/further.glsl" : "pass/further_none.glsl");
    slot_file(slots, "view-column",
              atmosphere->orders > 1 ? "pass/view_column_kept.glsl" : "sky/view_column_whole.glsl");
}

void further_uniforms(const Frame *frame, Uniforms *uniforms) {
    uniforms_declared_in(uniforms, "pass/view_column_kept.glsl");
    uniforms_float(uniforms, "view_aerosol_kept",
                   orders_kept(&frame->state.atmosphere, orders_plan_of(frame)));
}

static bool sky_integrates(const Frame *frame) {
    return frame->sky && frame->sky->method->integrates;
}

static bool wants_none(const void *frame) {
    (void)frame;
    return false;
}

static bool wants_further(const void *data) {
    const Frame *frame = data;
    return sky_integrates(frame) && frame->state.atmosphere.orders > 1;
}

static bool wants_ground(const void *data) {
    const Frame *frame = data;
    const Atmosphere *a = &frame->state.atmosphere;
    return sky_integrates(frame) && a->orders <= 1 && further_is_there(a);
}

static int table_columns(const Frame *frame) {
    return frame->coarse ? PREVIEW_COLUMNS : TABLE_COLUMNS;
}

static void size_uniforms(const Frame *frame, Uniforms *uniforms) {
    double size[3] = {table_columns(frame), TABLE_ROWS, TABLE_BELOW};
    uniforms_declared_in(uniforms, "pass/further_size.glsl");
    uniforms_vec3(uniforms, "further_size", size);
    uniforms_float(uniforms, "further_horizon", sky_horizon_sine(&frame->state.atmosphere));
    uniforms_float(uniforms, "further_limb", sky_limb_sine(&frame->state.atmosphere));
}

/* further_rays depend on the air, the observer and the quality, and not on the sun. The quality matters
 * because a share of the aerosols' extinction is left out with it (orders_kept()). */

static void rays_key(const void *data, Text *key) {
    const Frame *frame = data;
    orders_key(frame, key);
    text_append(key, &frame->state.atmosphere, sizeof frame->state.atmosphere);
}

static void rays_size(const void *data, int *width, int *height) {
    const Frame *frame = data;
    *width = 2 * RAY_NODES + 1;
    *height = 2 * TABLE_ROWS * spectrum_bands(&frame->state.atmosphere);
}

static void rays_uniforms(const Resource *rays, const void *frame, Uniforms *uniforms) {
    (void)rays;
    size_uniforms(frame, uniforms);
    orders_ray_uniforms(RAY_NODES, uniforms);
}

const ResourceKind further_rays = {.name = "the observer's rays",
                                   .entry = "pass/fill_further_rays.glsl",
                                   .samplers = {"further_rays_air", "further_rays_aerosols"},
                                   .filter = GL_NEAREST,
                                   .wanted = wants_none,
                                   .size = rays_size,
                                   .key = rays_key,
                                   .uniforms = rays_uniforms};

/* sky_further and sky_ground. */

static bool table_in_steps(const void *frame) {
    return ((const Frame *)frame)->in_steps;
}

static void table_size(const void *frame, int *width, int *height) {
    *width = TABLE_BELOW + table_columns(frame);
    *height = TABLE_ROWS;
}

static void ground_uniforms(const Resource *table, const void *frame, Uniforms *uniforms) {
    (void)table;
    size_uniforms(frame, uniforms);
    orders_gather_uniforms(frame, RAY_NODES, uniforms);
}

static void further_table_uniforms(const Resource *table, const void *frame, Uniforms *uniforms) {
    ground_uniforms(table, frame, uniforms);
    uniforms_declared_in(uniforms, "pass/fill_further.glsl");
    uniforms_int(uniforms, "sky_moments_degree", orders_plan_of(frame)->orders[0].degree);
}

const ResourceKind sky_further = {.name = "the further light",
                                  .entry = "pass/fill_further.glsl",
                                  .samplers = {"further_table"},
                                  .filter = GL_LINEAR,
                                  .inputs = {&further_rays, &sky_moments},
                                  .input_samplers = {{"rays_air", "rays_aerosols"}},
                                  .wanted = wants_further,
                                  .in_steps = table_in_steps,
                                  .size = table_size,
                                  .key = sky_key,
                                  .uniforms = further_table_uniforms};

const ResourceKind sky_ground = {.name = "the ground's light",
                                 .entry = "pass/fill_ground.glsl",
                                 .samplers = {"further_table"},
                                 .filter = GL_LINEAR,
                                 .inputs = {&further_rays},
                                 .input_samplers = {{"rays_air", "rays_aerosols"}},
                                 .wanted = wants_ground,
                                 .in_steps = table_in_steps,
                                 .size = table_size,
                                 .key = sky_key,
                                 .uniforms = ground_uniforms};
