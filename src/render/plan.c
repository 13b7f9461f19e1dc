#include "render/plan.h"

#include "base/text.h"
#include "choice/auto.h"
#include "gl/loops.h"
#include "render/inputs.h"
#include "sky/sky.h"
#include "sky/sun.h"

#include <stdio.h>
#include <string.h>

enum {
    MOST_GROUP_SAMPLES = 16,
    /* The smallest number of iterations at which a driver is known to end all loops of a shader (llvmpipe
     * before Mesa 25). The driver's own limit is measured only if a draw needs more. */
    LEAST_LOOP_LIMIT = 65535,
    /* Stands for "unlimited" where a loop needs a bound: the probability that Russian roulette lets a path
     * come so far is below 1e-22. */
    UNLIMITED_HITS = 1000,
    /* Estimates for one march() and one hit_spheres(): some 20 iterations are usual, and at most there are
     * MARCH_STEPS (glsl/shape/march.glsl) and SPHERES_STEPS (glsl/shape/spheres.glsl). glsl/pass/search.glsl
     * notices and counts rays that exceed all loops together. */
    MARCH_ITERATIONS = 200,
    SPHERES_ITERATIONS = 200,
    /* The longest chain of flat mirrors in glsl/sun/planes.glsl. */
    PLANE_CHAIN = 4
};

/* The loop iterations at one hit, including the searches of its rays and the loops over bounds, mirror
 * spheres and emitters. */
static long hit_iterations(const Plan *plan, const Scene *scene) {
    long emitter_count = scene_hint_count(scene, HINT_EMITTER_SPHERE);
    long mirror_count = scene_hint_count(scene, HINT_MIRROR_SPHERE);
    long plane_count = scene_hint_count(scene, HINT_MIRROR_PLANE);
    long bound_count = scene_hint_count(scene, HINT_BOUND);
    bool sun = plan->sun.method->samples_disk;
    long emitters = plan->needs.emits ? emitter_count : 0;
    long rays = 1 + (sun ? 1 : 0) + (sun && mirror_count ? 2 : 0) + (emitters ? 1 : 0);
    long bounds = plan->light.method->loops_over_bounds ? (emitters ? 3L : 2L) * bound_count : 0;
    long mirrors = sun && mirror_count ? 6 + 5 * mirror_count : 0;
    /* Each ray of a chain compares the mirror that it hit with the one that it should hit. */
    long planes = sun && plane_count ? PLANE_CHAIN * (3 + 2L * PLANE_CHAIN + plane_count) : 0;
    if (planes) rays += PLANE_CHAIN + 1;
    return 1 + rays * plan->needs.search_iterations + bounds + mirrors + planes + 3 * emitters;
}

/* Sets the number of samples of a draw. If the driver ends loops, "unlimited" is as many hits as its limit
 * allows. Without a context nothing is drawn and nothing is limited. */
static bool choose_group(Plan *plan, const RenderParams *params, const Context *context, Error *error) {
    const MethodChoice *sky = &plan->sky;
    long limit, hit = hit_iterations(plan, params->scene);
    long others = 1 + (sky->table ? 0 : sky->iterations) * (1 + plan->light.method->extra_sky_lookups);
    long iterations = others + (plan->max_hits + 1L) * hit;
    bool small = MOST_GROUP_SAMPLES * iterations <= LEAST_LOOP_LIMIT && sky->iterations <= LEAST_LOOP_LIMIT;
    plan->group_samples = MOST_GROUP_SAMPLES;
    if (small || !context) return true;
    if (plan->loop_limit == LOOP_LIMIT_UNKNOWN && !loops_probe(&context->gl, &plan->loop_limit, error))
        return false;
    limit = plan->loop_limit;
    if (!limit) return true;
    long most = (limit - others) / hit - 1;
    if (!params->max_hits && hit > 1 && most > 16 && most < plan->max_hits) plan->max_hits = (int)most;
    iterations = others + (plan->max_hits + 1L) * hit;
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

static bool same_hint(const Hint *a, const Hint *b) {
    return memcmp(a->words, b->words, sizeof a->words) == 0;
}

/* Whether each of the scene's bounds is one of its mirror spheres. */
static bool mirrors_alone_block(const Scene *scene) {
    int bounds = scene_hint_count(scene, HINT_BOUND), mirrors = scene_hint_count(scene, HINT_MIRROR_SPHERE);
    const HintList *lists = scene->file->hints;
    int same = 0;
    for (int i = 0; i < bounds; i++) {
        for (int k = 0; k < mirrors; k++) {
            if (!same_hint(&lists[HINT_BOUND].list[i], &lists[HINT_MIRROR_SPHERE].list[k])) continue;
            same++;
            break;
        }
    }
    return same == bounds;
}

static bool choose_methods(Plan *plan, const RenderParams *params, Error *error) {
    const Scene *scene = params->scene;
    const char *sky = params->sky ? params->sky : scene->file->sky[0] ? scene->file->sky : NULL;
    AutoWish wish = {.error_percent = params->error_percent,
                     .samples = (double)params->samples,
                     .pixels = (double)plan_width(params) * plan_height(params),
                     .sun_elevation_deg = scene->values.sun.elevation_deg,
                     .atmosphere = &scene->values.atmosphere,
                     .bounds = scene_hint_count(scene, HINT_BOUND) > 0,
                     .mirrors = mirrors_alone_block(scene),
                     .shiny = plan->needs.shiny};
    if (!auto_sky(&plan->sky, sky, &wish, error)) {
        if (params->sky) return false;
        error->status = STATUS_SCENE;
        return error_prefix(error, "%s:%d: ", scene->file->path, scene->file->sky_line);
    }
    return auto_light(&plan->light, params->light, &plan->sky, &wish, error) &&
           method_choose(&plan->sequence, METHOD_SEQUENCE, params->sequence, error) &&
           sun_choose(&plan->sun, params->sun_disk, scene, error);
}

int plan_width(const RenderParams *params) {
    return params->width ? params->width : params->scene->file->width;
}

int plan_height(const RenderParams *params) {
    return params->height ? params->height : params->scene->file->height;
}

/* Checks the scene's spheres; `calls` is the number of its calls of hit_spheres(). */
static bool check_spheres(const Scene *scene, const GlslSource *source, int calls, Error *error) {
    if (calls && !scene->file->spheres[0]) {
        return error_set(error, STATUS_SCENE,
                         "%s:1: hit_spheres() needs `//@ spheres COUNT` or `//@ spheres FILE.csv`",
                         scene->file->path);
    }
    if (scene->file->spheres[0] && scene_sphere_count(scene) >= 0 &&
        !glsl_source_defines(source, "scene_sphere")) {
        return error_set(error, STATUS_SCENE, "%s:%d: missing function: vec4 scene_sphere(int i)",
                         scene->file->path, scene->file->spheres_line);
    }
    return true;
}

/* Checks that the scene defines the functions that every scene must, and those that a scene with march()
 * must. */
static bool check_functions(const Scene *scene, const GlslSource *source, Error *error) {
    static const struct {
        /* `file`: only scenes that include it need the function; NULL if all do. */
        const char *name, *signature, *file;
    } functions[] = {
        {"scene_intersect", "void scene_intersect(Ray ray, INOUT(Hit) hit)", NULL},
        {"scene_material", "Material scene_material(Hit hit)", NULL},
        {"scene_distance", "float scene_distance(vec3 p)", "shape/march.glsl"},
    };
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        const char *file = functions[i].file;
        if (glsl_source_defines(source, functions[i].name)) continue;
        if (file && !glsl_source_includes(source, file)) continue;
        return error_set(error, STATUS_SCENE, "%s:1: missing function: %s", scene->file->path,
                         functions[i].signature);
    }
    return true;
}

static bool read_needs(const RenderParams *params, SceneNeeds *needs, Error *error) {
    GlslSource source;
    if (!glsl_source_create(&source, params->library, params->scene->file->path, NULL, error)) return false;
    bool ok = check_functions(params->scene, &source, error);
    int marches = glsl_source_calls(&source, "march"), spheres = glsl_source_calls(&source, "hit_spheres");
    if (ok) ok = check_spheres(params->scene, &source, spheres, error);
    *needs = (SceneNeeds){.search = glsl_source_includes(&source, "shape/search.glsl"),
                          .search_iterations =
                              (long)marches * MARCH_ITERATIONS + (long)spheres * SPHERES_ITERATIONS,
                          .emits = glsl_source_emits(&source),
                          .shiny = glsl_source_includes(&source, "material/glass.glsl") ||
                                   glsl_source_includes(&source, "material/rough_metal.glsl") ||
                                   glsl_source_includes(&source, "material/author.glsl"),
                          .throws = glsl_source_throws(&source),
                          .inputs = inputs_wanted(&source)};
    for (int i = 0; i < source.material_count && i < 20; i++)
        snprintf(needs->materials[i], sizeof needs->materials[i], "%s", source.materials[i]);
    glsl_source_destroy(&source);
    return ok;
}

bool plan_counts_chance(const Plan *plan) {
    return plan->sun.method->samples_disk && plan->needs.throws;
}

bool plan_choose(Plan *plan, const RenderParams *params, const Context *context, Error *error) {
    plan->max_hits = params->max_hits ? params->max_hits : UNLIMITED_HITS;
    plan->ozone = params->scene->values.atmosphere.ozone > 0;
    return choose_methods(plan, params, error) && choose_group(plan, params, context, error);
}

bool plan_make(Plan *plan, const RenderParams *params, const Context *context, Error *error) {
    *plan = (Plan){.loop_limit = LOOP_LIMIT_UNKNOWN};
    return read_needs(params, &plan->needs, error) && plan_choose(plan, params, context, error);
}

bool plan_same_programs(const Plan *a, const Plan *b) {
    return strcmp(a->sky.text, b->sky.text) == 0 && strcmp(a->light.text, b->light.text) == 0 &&
           strcmp(a->sequence.text, b->sequence.text) == 0 && strcmp(a->sun.text, b->sun.text) == 0 &&
           a->ozone == b->ozone;
}
