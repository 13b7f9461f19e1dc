#include "render/plan.h"

#include "base/text.h"
#include "choice/auto.h"
#include "gl/loops.h"
#include "render/inputs.h"
#include "scene/spectrum.h"
#include "sky/further.h"
#include "sky/sky.h"
#include "sky/sun.h"

#include <stdio.h>
#include <string.h>

enum {
    MOST_GROUP_SAMPLES = 16,
    /* Stands for "unlimited" where a loop needs a bound: the probability that Russian roulette lets a path
     * come so far is below 1e-22. */
    UNLIMITED_HITS = 1000,
    /* Estimates for one march() and one hit_spheres(): some 20 iterations are usual, and at most there are
     * MARCH_STEPS (glsl/shape/march.glsl) and SPHERES_STEPS (glsl/shape/spheres.glsl). glsl/pass/loops.glsl
     * notices and counts rays that exceed all loops together. */
    MARCH_ITERATIONS = 200,
    SPHERES_ITERATIONS = 200,
    /* Of one track through mist whose density the scene defines: MIST_STEPS
       (glsl/mist/function_density.glsl). */
    MIST_ITERATIONS = 64
};

/* Whether the plan's methods look for hints of that kind at each hit. */
static bool looks_for(const Plan *plan, HintKind kind) {
    switch (kind) {
    case HINT_BOUND:
        return plan->light.method->loops_over_bounds;
    case HINT_MIRROR_SPHERE:
    case HINT_MIRROR_PLANE:
        return plan->sun.method->samples_disk;
    case HINT_EMITTER_SPHERE:
        return plan->needs.emits;
    case HINT_PORTAL:
        return plan->light.method->samples_portals;
    case HINT_KINDS:
        break;
    }
    return false;
}

/* The loop iterations of one evaluation of the sky. */
static long sky_iterations(const Plan *plan) {
    return plan->sky.table ? 0 : plan->sky.iterations;
}

/* The loop iterations at one hit, including the searches of its rays, the loops over hints, and the sky where
 * the hit looks for it. */
static long hit_iterations(const Plan *plan, const Scene *scene) {
    /* With mist, rays to the sun are sent from two places: the surface, and one in the mist before it. */
    int places = plan->mist ? 2 : 1;
    long rays = 1 + (plan->sun.method->samples_disk ? places : 0), loops = 0;
    /* The ray from a place in the air, and its light's bands. */
    if (plan->air) {
        rays++;
        loops += spectrum_bands(&scene->values.atmosphere);
    }
    for (int i = 0; i < HINT_KINDS; i++) {
        HintKind kind = (HintKind)i;
        const HintInfo *info = hint_info(kind);
        int count = scene_hint_count(scene, kind);
        if (!count || !looks_for(plan, kind)) continue;
        int times = kind == HINT_MIRROR_SPHERE || kind == HINT_MIRROR_PLANE ? places : 1;
        rays += (long)times * info->rays;
        loops += times * (info->loops + (long)info->loops_each * count);
    }
    /* A bounce toward an emitter loops over the bounds once more. */
    if (looks_for(plan, HINT_BOUND) && looks_for(plan, HINT_EMITTER_SPHERE) &&
        scene_hint_count(scene, HINT_EMITTER_SPHERE))
        loops += scene_hint_count(scene, HINT_BOUND);
    if (looks_for(plan, HINT_PORTAL)) loops += sky_iterations(plan);
    /* The path's own way through mist takes three tracks, its way to the open sky one, and each other ray
     * one. */
    long tracks = plan->mist && scene->file->facts.makes_mist ? rays + 3 : 0;
    return 1 + rays * plan->needs.search_iterations + tracks * MIST_ITERATIONS + loops;
}

/* The loop iterations of a sample beside those at its hits, and of a sample in all. */
static long other_iterations(const Plan *plan) {
    return 1 + sky_iterations(plan) * (1 + plan->light.method->extra_sky_lookups);
}

static long sample_iterations(const Plan *plan, const RenderParams *params) {
    return other_iterations(plan) + (plan->max_hits + 1L) * hit_iterations(plan, params->scene);
}

bool plan_fit_loops(Plan *plan, const RenderParams *params, long limit, Error *error) {
    const MethodChoice *sky = &plan->sky;
    long hit = hit_iterations(plan, params->scene), most = (limit - other_iterations(plan)) / hit - 1;
    if (!params->max_hits && hit > 1 && most > 16 && most < plan->max_hits) plan->max_hits = (int)most;
    long iterations = sample_iterations(plan, params);
    if (iterations > limit || sky->iterations > limit) {
        return error_set(error, STATUS_USAGE,
                         "--sky %s with --light %s and %d surface hits needs %ld loop iterations a sample; "
                         "this OpenGL's limit is %ld",
                         sky->text, plan->light.text, plan->max_hits,
                         iterations > limit ? iterations : sky->iterations, limit);
    }
    while (plan->group_samples * iterations > limit) plan->group_samples /= 2;
    return true;
}

/* Sets the number of samples of a draw. If the driver ends loops, "unlimited" is as many hits as its limit
 * allows. Without a context nothing is drawn and nothing is limited. */
static bool choose_group(Plan *plan, const RenderParams *params, const Context *context, Error *error) {
    bool small = MOST_GROUP_SAMPLES * sample_iterations(plan, params) <= PLAN_LEAST_LOOP_LIMIT &&
                 plan->sky.iterations <= PLAN_LEAST_LOOP_LIMIT;
    plan->group_samples = MOST_GROUP_SAMPLES;
    if (small || !context) return true;
    if (plan->loop_limit == LOOP_LIMIT_UNKNOWN && !loops_probe(&context->gl, &plan->loop_limit, error))
        return false;
    return !plan->loop_limit || plan_fit_loops(plan, params, plan->loop_limit, error);
}

/* Whether each of the scene's bounds is one of its mirror spheres. If the scene defines either in GLSL, their
 * numbers are not known here, and the answer is no. */
static bool mirrors_alone_block(const Scene *scene) {
    int bounds = scene_hint_count(scene, HINT_BOUND), mirrors = scene_hint_count(scene, HINT_MIRROR_SPHERE);
    const HintList *lists = scene->file->hints;
    int same = 0;
    if (lists[HINT_BOUND].in_glsl || lists[HINT_MIRROR_SPHERE].in_glsl) return false;
    for (int i = 0; i < bounds; i++) {
        for (int k = 0; k < mirrors; k++) {
            if (!hint_same(HINT_BOUND, &lists[HINT_BOUND].list[i], &lists[HINT_MIRROR_SPHERE].list[k]))
                continue;
            same++;
            break;
        }
    }
    return same == bounds;
}

/* Light paths know Lambert's matte surfaces alone, no mist and no air, and the film has one sum for what is
 * splatted.
 */
static bool check_light_paths(Plan *plan, const RenderParams *params, Error *error) {
    bool chains = plan->sequence.method->walks_chains, own_lobe = plan->light.method->own_lobe;
    if (!plan->sun.method->traces_light || !(chains || own_lobe || plan->mist || plan->air)) return true;
    if (method_is_auto(params->sun_disk)) return method_choose(&plan->sun, METHOD_SUN, "sampled", error);
    if (chains) {
        return error_set(
            error, STATUS_USAGE,
            "--sun-disk %s: light paths cannot be traced beside the chains of --sequence %s; use "
            "--sun-disk sampled",
            plan->sun.text, plan->sequence.text);
    }
    if (plan->air) {
        return error_set(
            error, STATUS_USAGE,
            "--sun-disk %s: light paths do not know the air between the surfaces, which %s has in line "
            "%d; use --sun-disk sampled, or --set air=off",
            plan->sun.text, params->scene->file->path, params->scene->file->air_line);
    }
    if (plan->mist) {
        return error_set(error, STATUS_USAGE,
                         "--sun-disk %s: light paths are not scattered by mist, which %s has in line %d; use "
                         "--sun-disk sampled, or --set mist=off",
                         plan->sun.text, params->scene->file->path, params->scene->file->mist.line);
    }
    return error_set(
        error, STATUS_USAGE,
        "--sun-disk %s: light paths cannot be traced with --light %s, whose matte surfaces are not "
        "Lambert's; use --sun-disk sampled",
        plan->sun.text, plan->light.text);
}

static bool choose_methods(Plan *plan, const RenderParams *params, Error *error) {
    const Scene *scene = params->scene;
    const char *sky = params->sky ? params->sky : scene->file->sky[0] ? scene->file->sky : NULL;
    if (!sun_choose(&plan->sun, params->sun_disk, scene, error)) return false;
    AutoWish wish = {.error_percent = params->error_percent,
                     .samples = (double)params->samples,
                     .pixels = (double)plan_width(params) * plan_height(params),
                     .sun_elevation_deg = scene->values.sun.elevation_deg,
                     .atmosphere = &scene->values.atmosphere,
                     .bounds = scene_hint_count(scene, HINT_BOUND) > 0,
                     .mirrors = mirrors_alone_block(scene),
                     .room = scene_is_seen_from_room(scene),
                     .sun_disk = plan->sun.method->has_disk,
                     .shiny = plan->needs.shiny};
    if (!auto_further(&plan->further, params->further, sky, &wish, error)) return false;
    if (!auto_sky(&plan->sky, sky, &plan->further, &wish, error)) {
        if (params->sky) return false;
        error->status = STATUS_SCENE;
        return error_prefix(error, "%s:%d: ", scene->file->path, scene->file->sky_line);
    }
    return auto_light(&plan->light, params->light, &plan->sky, &wish, error) &&
           method_choose(&plan->sequence, METHOD_SEQUENCE, params->sequence, error) &&
           check_light_paths(plan, params, error);
}

int plan_width(const RenderParams *params) {
    return params->width ? params->width : params->scene->file->width;
}

int plan_height(const RenderParams *params) {
    return params->height ? params->height : params->scene->file->height;
}

/* Checks that the scene defines the functions that its text needs. */
static bool check_functions(const Scene *scene, Error *error) {
    const SceneFile *file = scene->file;
    if (file->facts.is_toy) {
        return error_set(
            error, STATUS_USAGE,
            "%s paints its picture by itself (mainImage() or main()), without sky and light: only "
            "`render` and `view` are for such files",
            file->path);
    }
    if (file->facts.missing)
        return error_set(error, STATUS_SCENE, "%s:1: missing function: %s", file->path, file->facts.missing);
    if (file->facts.hit_spheres_calls && !file->spheres[0]) {
        return error_set(error, STATUS_SCENE,
                         "%s:1: hit_spheres() needs `//@ spheres COUNT` or `//@ spheres FILE.csv`",
                         file->path);
    }
    if (file->facts.makes_mist && !file->mist.line) {
        return error_set(
            error, STATUS_SCENE,
            "%s:1: scene_mist() needs `//@ mist extinction E` and a region: it is a share of that "
            "extinction",
            file->path);
    }
    if (file->spheres[0] && scene_sphere_count(scene) >= 0 && !file->facts.makes_spheres) {
        return error_set(error, STATUS_SCENE, "%s:%d: missing function: vec4 scene_sphere(int i)", file->path,
                         file->spheres_line);
    }
    return true;
}

static SceneNeeds needs_of(const Scene *scene) {
    const SceneFacts *facts = &scene->file->facts;
    return (SceneNeeds){.search = facts->searches,
                        .search_iterations = (long)facts->march_calls * MARCH_ITERATIONS +
                                             (long)facts->hit_spheres_calls * SPHERES_ITERATIONS,
                        .emits = facts->emits,
                        .shiny = facts->has_glass || facts->has_rough_metal || facts->has_author,
                        .throws = facts->throws};
}

bool plan_counts_chance(const Plan *plan) {
    const Method *sun = plan->sun.method;
    return !plan->uncounted && !plan->sequence.method->walks_chains && sun->has_disk &&
           (plan->needs.throws || !sun->samples_disk);
}

bool plan_counts_searches(const Plan *plan) {
    return plan->needs.search && !plan->uncounted;
}

/* Both would scatter on the same way, with different coefficients and phase functions. */
static bool refuse_both(const SceneFile *file, Error *error) {
    return error_set(error, STATUS_SCENE,
                     "%s:%d: air and mist (line %d) are not computed together, because a way through both "
                     "has no closed form: --set mist=off or --set air=off leaves one of them out",
                     file->path, file->air_line, file->mist.line);
}

bool plan_choose(Plan *plan, const RenderParams *params, const Context *context, Error *error) {
    plan->max_hits = params->max_hits ? params->max_hits : UNLIMITED_HITS;
    plan->ozone = params->scene->values.atmosphere.ozone > 0;
    plan->has_further = further_is_there(&params->scene->values.atmosphere);
    plan->has_orders = params->scene->values.atmosphere.orders > 1;
    plan->spectrum = params->scene->values.atmosphere.spectrum;
    plan->mist = scene_has_mist(params->scene);
    plan->air = scene_has_air(params->scene);
    if (plan->mist && plan->air) return refuse_both(params->scene->file, error);
    return choose_methods(plan, params, error) && choose_group(plan, params, context, error);
}

bool plan_make(Plan *plan, const RenderParams *params, const Context *context, Error *error) {
    *plan = (Plan){.loop_limit = LOOP_LIMIT_UNKNOWN, .needs = needs_of(params->scene)};
    return check_functions(params->scene, error) && plan_choose(plan, params, context, error);
}

bool plan_same_programs(const Plan *a, const Plan *b) {
    return strcmp(a->sky.text, b->sky.text) == 0 && strcmp(a->light.text, b->light.text) == 0 &&
           strcmp(a->sequence.text, b->sequence.text) == 0 && strcmp(a->sun.text, b->sun.text) == 0 &&
           a->ozone == b->ozone && a->spectrum == b->spectrum && a->has_further == b->has_further &&
           a->has_orders == b->has_orders && a->mist == b->mist && a->air == b->air;
}
