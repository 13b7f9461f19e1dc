#include "export/toy_hold.h"

#include "render/passes.h"
#include "sky/scattered.h"

#include <stdio.h>
#include <string.h>

/* Where the scene says it, or its first line where an option or a preset does. */
static bool refuse(const SceneFile *file, int line, const char *what, const char *way, Error *error) {
    return error_set(error, STATUS_SCENE, "%s:%d: Shadertoy's texts do not hold %s: %s", file->path,
                     line ? line : 1, what, way);
}

static bool refuse_option(const char *option, const char *word, const char *what, const char *way,
                          Error *error) {
    return error_set(error, STATUS_USAGE, "%s %s: Shadertoy's texts do not hold %s: %s", option, word, what,
                     way);
}

static bool hold_methods(const Plan *plan, Error *error) {
    const Method *light = plan->light.method;
    if (plan->sky.table)
        return refuse_option("--sky", plan->sky.text, "the sky's table",
                             "name the method that fills it, such as gauss:6", error);
    if (light->needs_irradiance || light->needs_sky_sampler)
        return refuse_option("--light", plan->light.text, "the tables of this method",
                             "leave the option out, the picture is the same but for its noise", error);
    if (plan->sequence.method->walks_chains)
        return refuse_option("--sequence", plan->sequence.text, "the passes of Markov chains",
                             "leave the option out", error);
    return true;
}

/* Whether the option, and not the scene, asks for the sun's disk. */
static bool hold_sun(const Plan *plan, const RenderParams *params, Error *error) {
    static const char what[] =
        "the sun's disk, whose light and image come from tables and passes of their own";
    if (!plan->sun.method->has_disk) return true;
    if (params->sun_disk) return refuse_option("--sun-disk", params->sun_disk, what, "leave it out", error);
    return refuse(params->scene->file, params->scene->file->sun_disk_line, what,
                  "--sun-disk=off leaves it out", error);
}

static bool hold_scene(const Plan *plan, const RenderParams *params, Error *error) {
    const SceneFile *file = params->scene->file;
    if (file->spheres[0])
        return refuse(file, file->spheres_line, "the tree of hit_spheres()",
                      "a few spheres may be written as hit_sphere()", error);
    if (sky_is_scattered(&plan->sky, params->scene))
        return refuse(file, file->mist.line, "the table of this sky's light in mist",
                      "--set mist=off leaves the mist out, and --sky gauss:6 needs no such table", error);
    if (plan->has_further && plan->sky.method->integrates)
        return refuse(file, file->atmosphere_line,
                      "light that is scattered more than once or comes from the planet's ground, which fills "
                      "tables",
                      "--orders 1 --set atmosphere.ground_albedo=0 leaves it out", error);
    return true;
}

bool toy_hold_plan(const Plan *plan, const RenderParams *params, Error *error) {
    return hold_methods(plan, error) && hold_sun(plan, params, error) && hold_scene(plan, params, error);
}

/* The table that the sampler reads. */
static const char *table_of(const GlslTokens *tokens, int sampler) {
    for (const ResourceKind *const *kind = picture_tables; *kind; kind++) {
        for (int i = 0; i < RESOURCE_TEXTURES; i++) {
            const char *name = (*kind)->samplers[i];
            if (name && glsl_token_is(tokens, sampler, name)) return (*kind)->name;
        }
    }
    return "a texture";
}

bool toy_hold_text(const GlslTokens *tokens, const RenderParams *params, Error *error) {
    for (int i = 0; i + 2 < tokens->count; i++) {
        if (!glsl_token_is(tokens, i, "uniform") || !glsl_token_is(tokens, i + 1, "sampler2D")) continue;
        return refuse(params->scene->file, 0, table_of(tokens, i + 2),
                      "leave out what needs it (`magichour explain` tells the terms)", error);
    }
    return true;
}
