#include "sky/sky.h"

#include "choice/bias.h"
#include "sky/further.h"
#include "sky/gauss_table.h"
#include "sky/sky_spectrum.h"

#include <math.h>
#include <stdio.h>

void sky_slots(SlotList *slots, const MethodChoice *choice, const Atmosphere *atmosphere) {
    const char *sky = choice->table                ? "pass/sky_table.glsl"
                      : choice->method->integrates ? "pass/sky_direct.glsl"
                                                   : choice->method->file;
    char nodes[96];
    int count = choice->method->numbers == NUMBERS_NODES ? choice->nodes : 0;
    snprintf(nodes, sizeof nodes, "const int GAUSS_NODES = %d;\nint gauss_count() { return %d; }", count,
             count);
    slot_file(slots, "sky", sky);
    slot_file(slots, "sums", choice->method->file);
    slot_file(slots, "absorber",
              atmosphere->ozone > 0 ? "sky/absorber_ozone.glsl" : "sky/absorber_none.glsl");
    slot_text(slots, "gauss-nodes", nodes);
    further_slots(slots, atmosphere);
    sky_spectrum_slots(slots, atmosphere);
}

static void atmosphere_uniforms(const Atmosphere *a, Uniforms *uniforms) {
    double rayleigh[3], mie[3], extinction[3], ozone[3];
    for (int c = 0; c < 3; c++) {
        rayleigh[c] = a->rayleigh * a->rayleigh_scatter_per_m[c];
        mie[c] = a->mie * a->mie_scatter_per_m[c];
        extinction[c] = mie[c] * a->mie_extinction_ratio;
        ozone[c] = a->ozone * a->ozone_absorb_per_m[c];
    }
    uniforms_declared_in(uniforms, "pass/atmosphere.glsl");
    uniforms_float(uniforms, "observer_height_m", a->observer_height_m);
    uniforms_float(uniforms, "atmosphere.planet_radius_m", a->planet_radius_m);
    uniforms_float(uniforms, "atmosphere.thickness_m", a->top_radius_m - a->planet_radius_m);
    uniforms_float(uniforms, "atmosphere.rayleigh_scale_height_m", a->rayleigh_scale_height_m);
    uniforms_float(uniforms, "atmosphere.mie_scale_height_m", a->mie_scale_height_m);
    uniforms_vec3(uniforms, "atmosphere.rayleigh_scatter_per_m", rayleigh);
    uniforms_vec3(uniforms, "atmosphere.mie_scatter_per_m", mie);
    uniforms_vec3(uniforms, "atmosphere.mie_extinction_per_m", extinction);
    uniforms_float(uniforms, "atmosphere.mie_g", a->mie_g);
    uniforms_vec3(uniforms, "atmosphere.ozone_absorb_per_m", ozone);
    uniforms_float(uniforms, "atmosphere.ozone_height_m", a->ozone_height_m);
    uniforms_float(uniforms, "atmosphere.ozone_half_width_m", a->ozone_half_width_m);
    uniforms_vec3(uniforms, "atmosphere.sun_irradiance", a->sun_irradiance);
}

static void method_uniforms(const MethodChoice *choice, Uniforms *uniforms) {
    uniforms_declared_in(uniforms, choice->method->file);
    switch (choice->method->numbers) {
    case NUMBERS_NODES: {
        GaussTable table = gauss_table(choice->nodes);
        int n = choice->nodes;
        uniforms_floats(uniforms, "gauss_table.node", table.node, n);
        uniforms_floats(uniforms, "gauss_table.weight", table.weight, n);
        uniforms_floats(uniforms, "gauss_table.cumulative", table.cumulative, n * n);
        break;
    }
    case NUMBERS_STEPS:
        uniforms_int(uniforms, "sky_view_samples", choice->steps.view);
        uniforms_int(uniforms, "sky_light_samples", choice->steps.light);
        break;
    case NUMBERS_LEVEL:
        uniforms_float(uniforms, "sky_level", choice->level);
        break;
    case NUMBERS_DEGREE:
    case NUMBERS_NONE:
        break;
    }
}

void sky_uniforms(const Frame *frame, Uniforms *uniforms) {
    uniforms_declared_in(uniforms, "pass/sun.glsl");
    uniforms_vec3(uniforms, "sun_direction", frame->state.sun.direction);
    uniforms_vec3(uniforms, "sun_level", frame->state.sun.level);
    atmosphere_uniforms(&frame->state.atmosphere, uniforms);
    sky_spectrum_uniforms(&frame->state.atmosphere, uniforms);
    further_uniforms(frame, uniforms);
    method_uniforms(frame->sky, uniforms);
}

enum { FEWEST_COLUMNS = 16 };

static bool wants_table(const void *frame) {
    return ((const Frame *)frame)->sky->table;
}

static bool table_in_steps(const void *frame) {
    return ((const Frame *)frame)->in_steps;
}

static void table_size(const void *data, int *columns, int *rows) {
    const Frame *frame = data;
    bias_table_size(frame->sky, frame->state.sun.elevation_deg, &frame->state.atmosphere, columns, rows);
    /* A quarter of the texels. The glow around the sun needs some columns in any case. */
    if (frame->coarse && *columns >= 2 * FEWEST_COLUMNS) {
        *columns /= 2;
        *rows /= 2;
    }
    *rows *= 2;
}

/* The uniforms are the number of rows in a half, and the sines of elevation between which a direction
 * passes through air: those of the visible horizon, and of the atmosphere's limb seen from outside (1 from
 * within). */
static void table_uniforms(const Resource *table, const void *data, Uniforms *uniforms) {
    const Frame *frame = data;
    const Atmosphere *a = &frame->state.atmosphere;
    int columns, rows;
    (void)table;
    table_size(frame, &columns, &rows);
    double size[3] = {columns, rows / 2, 0};
    uniforms_declared_in(uniforms, "pass/sky_table_size.glsl");
    uniforms_vec3(uniforms, "sky_table_size", size);
    uniforms_float(uniforms, "sky_horizon", sky_horizon_sine(a));
    uniforms_float(uniforms, "sky_limb", sky_limb_sine(a));
}

const ResourceKind sky_table = {.name = "the sky's table",
                                .entry = "pass/fill_table.glsl",
                                .samplers = {"sky_table_rayleigh", "sky_table_mie"},
                                .filter = GL_LINEAR,
                                .wanted = wants_table,
                                .in_steps = table_in_steps,
                                .size = table_size,
                                .key = sky_key,
                                .uniforms = table_uniforms};
