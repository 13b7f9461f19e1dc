#include "chart/term.h"

#include "base/memory.h"
#include "scene/spectrum.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A planet that is this many times larger, with the same air above it, counts as flat. */
static const double flat = 100;

/* The albedo of a ground that is black in the scene and is lit for comparison: that of the air `earth`. */
static const double lit_albedo = 0.1;

Variation *variation_create(const RenderParams *params) {
    Variation *variation = memory_get(1, sizeof *variation);
    variation->scene = *params->scene;
    variation->params = *params;
    variation->params.scene = &variation->scene;
    return variation;
}

static TermState state_of(bool possible, bool on) {
    return !possible ? TERM_NONE : on ? TERM_ON : TERM_OFF;
}

static bool has_air(const Renderer *renderer) {
    return renderer->plan.sky.method->integrates;
}

static TermState rayleigh_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)term;
    return state_of(has_air(renderer), params->scene->values.atmosphere.rayleigh > 0);
}

static void rayleigh_turn(const Term *term, Variation *variation, bool on) {
    (void)term;
    variation->scene.values.atmosphere.rayleigh = on;
}

static TermState mie_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)term;
    return state_of(has_air(renderer), params->scene->values.atmosphere.mie > 0);
}

static void mie_turn(const Term *term, Variation *variation, bool on) {
    (void)term;
    variation->scene.values.atmosphere.mie = on;
}

static TermState ozone_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)term;
    return state_of(has_air(renderer), params->scene->values.atmosphere.ozone > 0);
}

static void ozone_turn(const Term *term, Variation *variation, bool on) {
    (void)term;
    variation->scene.values.atmosphere.ozone = on;
}

static TermState curvature_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)term;
    return state_of(has_air(renderer) && flat * params->scene->values.atmosphere.planet_radius_m < 1e9, true);
}

static bool asks_table(const Variation *variation) {
    MethodChoice choice;
    Error ignored;
    return method_choose(&choice, METHOD_SKY, variation->params.sky, &ignored) && choice.table;
}

/* Rays to a flat horizon are long. With few nodes, their error would be larger than the change by the
 * curvature. */
static void curvature_turn(const Term *term, Variation *variation, bool on) {
    (void)term;
    (void)on;
    Atmosphere *a = &variation->scene.values.atmosphere;
    double thickness = a->top_radius_m - a->planet_radius_m;
    a->planet_radius_m *= flat;
    a->top_radius_m = a->planet_radius_m + thickness;
    variation->params.sky = asks_table(variation) ? "table:gauss:12" : "gauss:12";
}

static TermState orders_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)term;
    return state_of(has_air(renderer), params->scene->values.atmosphere.orders > 1);
}

static void orders_turn(const Term *term, Variation *variation, bool on) {
    (void)term;
    variation->scene.values.atmosphere.orders = on ? INFINITY : 1;
}

static TermState ground_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)term;
    const double *albedo = params->scene->values.atmosphere.ground_albedo;
    return state_of(has_air(renderer), albedo[0] > 0 || albedo[1] > 0 || albedo[2] > 0);
}

static void ground_turn(const Term *term, Variation *variation, bool on) {
    (void)term;
    for (int c = 0; c < 3; c++) variation->scene.values.atmosphere.ground_albedo[c] = on ? lit_albedo : 0;
}

static TermState spectrum_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)term;
    Atmosphere air = params->scene->values.atmosphere;
    Error ignored;
    bool on = air.spectrum != SPECTRUM_RGB;
    air.spectrum = MOST_WAVELENGTHS;
    return state_of(has_air(renderer) && spectrum_check(&air, &ignored), on);
}

static void spectrum_turn(const Term *term, Variation *variation, bool on) {
    (void)term;
    variation->scene.values.atmosphere.spectrum = on ? MOST_WAVELENGTHS : SPECTRUM_RGB;
}

/* The terms "harmonics beyond degree N". */
static TermState harmonics_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    return state_of(has_air(renderer) && params->scene->values.atmosphere.orders > 1,
                    renderer->plan.further.degree > term->number);
}

static void harmonics_turn(const Term *term, Variation *variation, bool on) {
    variation->params.further = on ? "harmonics:14" : term->number == 10 ? "harmonics:10" : "harmonics:8";
}

static bool has_disk(const Renderer *renderer) {
    return renderer->plan.sun.method->has_disk;
}

static TermState disk_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)term;
    return state_of(params->scene->values.sun.elevation_deg > -params->scene->values.sun.radius_deg,
                    has_disk(renderer));
}

static void disk_turn(const Term *term, Variation *variation, bool on) {
    (void)term;
    variation->params.sun_disk = on ? "auto" : "off";
}

/* Sunlight by way of the mirrors that hints of a kind name. If the term is off, only random bounces look for
 * this light, and they find nearly none of it. */
static TermState mirrors_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    return state_of(has_disk(renderer) && scene_hint_count(params->scene, (HintKind)term->number) > 0, true);
}

static void hint_turn(const Term *term, Variation *variation, bool on) {
    (void)on;
    variation->scene.values.ignored_hints |= 1U << term->number;
}

static TermState hits_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)renderer;
    return state_of(true, !params->max_hits || params->max_hits > term->number);
}

static void hits_turn(const Term *term, Variation *variation, bool on) {
    variation->params.max_hits = on ? 0 : term->number;
}

/* The terms "more than N nodes". */
static TermState nodes_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)params;
    const MethodChoice *sky = &renderer->plan.sky;
    return state_of(sky->method->numbers == NUMBERS_NODES, sky->nodes > term->number);
}

static void nodes_turn(const Term *term, Variation *variation, bool on) {
    static const char *const tables[] = {[4] = "table:gauss:4", [6] = "table:gauss:6", [8] = "table:gauss:8"};
    const char *table = on ? "table:gauss:12" : tables[term->number];
    variation->params.sky = table + (asks_table(variation) ? 0 : strlen("table:"));
}

static TermState direct_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)term;
    (void)params;
    return state_of(has_air(renderer), !renderer->plan.sky.table);
}

static void direct_turn(const Term *term, Variation *variation, bool on) {
    (void)term;
    variation->params.sky = on ? "gauss:8" : "table:gauss:8";
}

static TermState control_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)term;
    return state_of(renderer->plan.sky.table && scene_hint_count(params->scene, HINT_BOUND) > 0,
                    renderer->plan.light.method->needs_irradiance);
}

static void control_turn(const Term *term, Variation *variation, bool on) {
    (void)term;
    variation->params.light = on ? "control" : "cosine";
}

static TermState sampling_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)term;
    (void)params;
    return state_of(true, renderer->plan.light.method->needs_sky_sampler);
}

static void sampling_turn(const Term *term, Variation *variation, bool on) {
    (void)term;
    variation->params.light = on ? "mis" : "cosine";
}

static TermState portals_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)term;
    return state_of(scene_hint_count(params->scene, HINT_PORTAL) > 0,
                    renderer->plan.light.method->samples_portals);
}

static void portals_turn(const Term *term, Variation *variation, bool on) {
    (void)term;
    variation->params.light = on ? "portal" : "cosine";
}

static TermState sequence_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)term;
    (void)params;
    return state_of(true, renderer->plan.sequence.method->low_discrepancy);
}

static void sequence_turn(const Term *term, Variation *variation, bool on) {
    (void)term;
    variation->params.sequence = on ? "sobol" : "random";
}

static TermState emitters_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)renderer;
    return state_of(scene_hint_count(params->scene, (HintKind)term->number) > 0, true);
}

/* The terms that are checkboxes of the scene. */
static TermState checkbox_state(const Term *term, const RenderParams *params, const Renderer *renderer) {
    (void)renderer;
    /* Mist and air are not computed together, so that neither is turned on beside the other. */
    const SceneFile *file = params->scene->file;
    bool mist = file->mist.line && term->number == file->mist.parameter && scene_has_air(params->scene);
    bool air = file->air_line && term->number == file->air_parameter && scene_has_mist(params->scene);
    return state_of(!mist && !air, params->scene->values.parameters[term->number][0] > 0);
}

static void checkbox_turn(const Term *term, Variation *variation, bool on) {
    variation->scene.values.parameters[term->number][0] = on;
}

static const Term terms[] = {
    {"Rayleigh scattering", false, rayleigh_state, rayleigh_turn, 0},
    {"Mie scattering", false, mie_state, mie_turn, 0},
    {"ozone", false, ozone_state, ozone_turn, 0},
    {"the planet's curvature", false, curvature_state, curvature_turn, 0},
    {"further orders of scattering", false, orders_state, orders_turn, 0},
    {"light from the ground", false, ground_state, ground_turn, 0},
    {"colours from a spectrum", false, spectrum_state, spectrum_turn, 0},
    {"the sun's disk", false, disk_state, disk_turn, 0},
    {"sunlight off mirror spheres", false, mirrors_state, hint_turn, HINT_MIRROR_SPHERE},
    {"sunlight off flat mirrors", false, mirrors_state, hint_turn, HINT_MIRROR_PLANE},
    {"hits beyond the first", false, hits_state, hits_turn, 1},
    {"hits beyond the second", false, hits_state, hits_turn, 2},
    {"hits beyond the fourth", false, hits_state, hits_turn, 4},
    {"hits beyond the eighth", false, hits_state, hits_turn, 8},
    {"more than 4 nodes of gauss", false, nodes_state, nodes_turn, 4},
    {"more than 6 nodes", false, nodes_state, nodes_turn, 6},
    {"more than 8 nodes", false, nodes_state, nodes_turn, 8},
    {"harmonics beyond degree 8", false, harmonics_state, harmonics_turn, 8},
    {"harmonics beyond degree 10", false, harmonics_state, harmonics_turn, 10},
    {"the sky without a table", false, direct_state, direct_turn, 0},
    {"control variate, toward bounds", true, control_state, control_turn, 0},
    {"sky light sampling (mis)", true, sampling_state, sampling_turn, 0},
    {"sky light by way of portals", true, portals_state, portals_turn, 0},
    {"looking for emitters", true, emitters_state, hint_turn, HINT_EMITTER_SPHERE},
    {"low-discrepancy sequence", true, sequence_state, sequence_turn, 0},
};
enum { TERMS = sizeof terms / sizeof *terms };

Term *term_list(const RenderParams *params, int *count) {
    const Scene *scene = params->scene;
    Term *list = memory_get(TERMS + (size_t)scene->file->parameter_count, sizeof *list);
    memcpy(list, terms, sizeof terms);
    *count = TERMS;
    for (int i = 0; i < scene->file->parameter_count; i++) {
        const Parameter *parameter = &scene->file->parameters[i];
        if (parameter->type != PARAMETER_CHECKBOX) continue;
        Term *term = &list[(*count)++];
        *term = (Term){.state = checkbox_state, .turn = checkbox_turn, .number = i};
        snprintf(term->name, sizeof term->name, "%.40s (the scene's)", parameter->name);
    }
    return list;
}
