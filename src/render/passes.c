#include "render/passes.h"

#include "render/drawn_mirrors.h"
#include "render/inputs.h"
#include "render/mist.h"
#include "render/spheres.h"
#include "sky/further.h"
#include "sky/irradiance.h"
#include "sky/scattered.h"
#include "sky/scene_air.h"
#include "sky/sky_sampler.h"
#include "sky/sun.h"
#include "source/glsl_missing.h"

#include <string.h>

/* The mirrors come first, because drawn_mirrors_ask() fills them before all other tables. The spheres come
 * next, because only they can be refused: then no other table has been changed. */
const ResourceKind *const picture_tables[] = {
    &drawn_mirrors,  &drawn_spheres, &scene_spheres, &file_spheres, FURTHER_TABLES, &sky_table, &sky_patches,
    &sky_irradiance, &sky_scattered, &sky_sampler,   &sun_table,    &sun_cover,     NULL};

const Pass trace_pass = {.name = "trace", .entry = "pass/trace.glsl"};
const Pass sun_image_pass = {.name = "the sun's image", .entry = "pass/sun_image.glsl"};
const Pass aov_pass_entry = {.name = "layers", .entry = "pass/aov.glsl"};
const Pass throwers_pass = {.name = "throwers", .entry = "pass/throwers.glsl"};
const Pass photons_pass = {.name = "light paths", .entry = "pass/photons.glsl"};
const Pass chain_steps_pass = {.name = "chains", .entry = "pass/metropolis.glsl"};
const Pass chain_keep_pass = {.name = "chains' numbers", .entry = "pass/metropolis_keep.glsl"};
const Pass chain_film_pass = {.name = "film", .entry = "pass/metropolis_film.glsl"};
const Pass check_pass = {.name = "check", .entry = "pass/check.glsl"};

const Pass *film_pass(const Plan *plan) {
    return plan->sequence.method->walks_chains ? &chain_film_pass : &trace_pass;
}

const Pass *paths_pass(const Plan *plan) {
    return plan->sequence.method->walks_chains ? &chain_steps_pass : &trace_pass;
}

PassList pass_list(const Plan *plan, const RenderParams *params) {
    PassList list = {0};
    Camera camera = camera_of(params->scene, plan_width(params), plan_height(params));
    Frame frame = frame_of(plan, params, &camera);
    for (const ResourceKind *const *kind = picture_tables; *kind; kind++) {
        if (!(*kind)->entry || !resource_is_needed(*kind, picture_tables, &frame)) continue;
        list.passes[list.count++] = (Pass){.name = (*kind)->name, .entry = (*kind)->entry, .fills = *kind};
    }
    if (plan->sun.method->draws_image) list.passes[list.count++] = sun_image_pass;
    if (plan->sun.method->traces_light) {
        list.passes[list.count++] = throwers_pass;
        list.passes[list.count++] = photons_pass;
    }
    if (plan->sequence.method->walks_chains) {
        list.passes[list.count++] = chain_steps_pass;
        list.passes[list.count++] = chain_keep_pass;
    }
    list.passes[list.count++] = *film_pass(plan);
    list.passes[list.count++] = aov_pass_entry;
    list.passes[list.count++] = check_pass;
    return list;
}

/* Writes the annotated hints of a kind as GLSL. If the scene defines the function itself, nothing is left to
 * write: it is in the scene's own text. */
static void hint_slot(SlotList *slots, const char *name, const Scene *scene, HintKind kind) {
    static const HintList none = {0};
    const HintList *hints = &scene->file->hints[kind];
    Text text = {0};
    if (!hints->in_glsl) hint_write(kind, scene_hint_count(scene, kind) ? hints : &none, &text);
    slot_text(slots, name, text_string(&text));
    text_free(&text);
}

static void scene_slots(SlotList *slots, const Plan *plan, const Scene *scene) {
    Text inputs = {0};
    const char *emission = !plan->needs.emits                             ? "emission/none.glsl"
                           : scene_hint_count(scene, HINT_EMITTER_SPHERE) ? "emission/sampled.glsl"
                                                                          : "emission/chance.glsl";
    scene_facts_declare_inputs(&scene->file->facts, &inputs);
    slot_text(slots, "inputs", text_string(&inputs));
    text_free(&inputs);
    slot_file(slots, "scene", scene->file->path);
    slot_file(slots, "spheres", spheres_slot(scene));
    slot_file(slots, "emission", emission);
    mist_slots(slots, plan, scene);
    hint_slot(slots, "bounds", scene, HINT_BOUND);
    hint_slot(slots, "mirror-spheres", scene, HINT_MIRROR_SPHERE);
    hint_slot(slots, "mirror-planes", scene, HINT_MIRROR_PLANE);
    hint_slot(slots, "emitter-spheres", scene, HINT_EMITTER_SPHERE);
    hint_slot(slots, "portals", scene, HINT_PORTAL);
}

/* One list of slots serves all programs: an entry file uses the slots that it names. */
bool pass_text(const Pass *pass, const Plan *plan, const RenderParams *params, GlslSource *source,
               Error *error) {
    SlotList slots = {0};
    sky_slots(&slots, &plan->sky, &params->scene->values.atmosphere);
    sun_slots(&slots, &plan->sun, params->scene);
    scene_slots(&slots, plan, params->scene);
    slot_file(&slots, "sequence", plan->sequence.method->file);
    slot_file(&slots, "light", plan->light.method->file);
    slot_file(&slots, "scatter", params->variance ? "pass/scatter.glsl" : "pass/scatter_none.glsl");
    slot_file(&slots, "rejects", params->rejects ? "pass/rejects.glsl" : "pass/rejects_none.glsl");
    slot_file(&slots, "search", plan_counts_searches(plan) ? "pass/search.glsl" : "pass/search_none.glsl");
    slot_file(&slots, "loops", plan_counts_searches(plan) ? "pass/loops.glsl" : "pass/loops_none.glsl");
    slot_file(&slots, "chance", plan_counts_chance(plan) ? "pass/chance.glsl" : "pass/chance_none.glsl");
    bool ok = glsl_source_create(source, params->scene->file->sources, pass->entry, slots.slots, error);
    slot_list_free(&slots);
    return ok;
}

bool pass_compile(Program *program, const GlApi *gl, const GlslSource *source, const RenderParams *params,
                  Error *error) {
    if (program_create(program, gl, source, error)) return true;
    /* If the scene's text ends too early, the compiler reports the error in the library's text behind it. */
    const SceneFile *file = params->scene->file;
    glsl_missing_advise(source, file->sources->folder, error);
    if (strncmp(error->text, file->sources->folder, strlen(file->sources->folder)) == 0)
        error_prefix(error, "%s: ", file->path);
    return false;
}

bool pass_program(Program *program, const Pass *pass, const GlApi *gl, const Plan *plan,
                  const RenderParams *params, Error *error) {
    GlslSource source = {0};
    bool ok =
        pass_text(pass, plan, params, &source, error) && pass_compile(program, gl, &source, params, error);
    glsl_source_destroy(&source);
    return ok;
}

bool pass_trace_text(const RenderParams *params, GlslSource *source, Error *error) {
    Plan plan;
    return plan_make(&plan, params, NULL, error) &&
           pass_text(paths_pass(&plan), &plan, params, source, error);
}

Frame frame_of(const Plan *plan, const RenderParams *params, const Camera *camera) {
    const Scene *scene = params->scene;
    return (Frame){.state = {scene->values.atmosphere, scene->values.sun},
                   .sky = &plan->sky,
                   .further = &plan->further,
                   .light = &plan->light,
                   .sun_disk = &plan->sun,
                   .scene = scene,
                   .camera = *camera,
                   .first_sample = params->first_sample,
                   .coarse = params->use == PICTURE_PREVIEW,
                   .in_steps = params->use == PICTURE_AT_REST};
}

/* Samples have numbers of 32 bits. Each lap of so many samples has a seed of its own. */
static unsigned lap_seed(unsigned seed, uint64_t first_sample) {
    return seed ^ (unsigned)(first_sample >> 32) * 0x9e3779b9U;
}

void frame_uniforms(const Frame *frame, const Plan *plan, unsigned seed, Uniforms *uniforms) {
    seed = lap_seed(seed, frame->first_sample);
    sky_uniforms(frame, uniforms);
    camera_uniforms(&frame->camera, uniforms);
    inputs_uniforms(frame, uniforms);
    if (plan->air) scene_air_uniforms(&frame->state.atmosphere, uniforms);
    uniforms_declared_in(uniforms, "pass/film_samples.glsl");
    uniforms_uint(uniforms, "film_first", (unsigned)frame->first_sample);
    uniforms_declared_in(uniforms, "pass/trace.glsl");
    uniforms_uint(uniforms, "seed", seed);
    uniforms_int(uniforms, "max_hits", plan->max_hits);
    uniforms_declared_in(uniforms, "pass/metropolis.glsl");
    uniforms_int(uniforms, "max_hits", plan->max_hits);
    uniforms_declared_in(uniforms, "pass/chains.glsl");
    uniforms_uint(uniforms, "seed", seed);
    uniforms_declared_in(uniforms, "pass/sun_image.glsl");
    uniforms_uint(uniforms, "seed", seed);
    uniforms_declared_in(uniforms, "pass/aov.glsl");
    uniforms_uint(uniforms, "seed", seed);
    uniforms_declared_in(uniforms, "pass/throwers.glsl");
    uniforms_uint(uniforms, "seed", seed);
    uniforms_declared_in(uniforms, "pass/photons.glsl");
    uniforms_uint(uniforms, "seed", seed);
    uniforms_int(uniforms, "max_hits", plan->max_hits);
}
