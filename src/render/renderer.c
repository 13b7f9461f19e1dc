#include "render/renderer.h"

#include "choice/bias.h"
#include "render/drawn_mirrors.h"

#include <math.h>
#include <string.h>

static bool create_program(Renderer *renderer, const Context *context, const RenderParams *params,
                           Error *error) {
    const Plan *plan = &renderer->plan;
    return pass_program(&renderer->program, film_pass(plan), &context->gl, plan, params, error);
}

static bool list_files(Renderer *renderer, const RenderParams *params, Error *error) {
    GlslSource source = {0};
    bool ok = pass_text(paths_pass(&renderer->plan), &renderer->plan, params, &source, error);
    for (int i = 0; i < source.file_count; i++)
        text_print(&renderer->source_files, "%s%s", i ? " " : "", source.files[i]);
    glsl_source_destroy(&source);
    return ok;
}

/* The data of text() for resources_create(). */
typedef struct Texts {
    const Plan *plan;
    const RenderParams *params;
} Texts;

static bool make_text(const void *data, const char *entry, GlslSource *source, Error *error) {
    const Texts *texts = data;
    Pass pass = {.entry = entry};
    return pass_text(&pass, texts->plan, texts->params, source, error);
}

static bool create_tables(Renderer *renderer, const Context *context, const RenderParams *params,
                          const Frame *frame, Error *error) {
    Texts texts = {&renderer->plan, params};
    ResourceTexts maker = {make_text, &texts};
    return resources_create(&renderer->tables, context, picture_tables, frame, &maker, error);
}

static void give(const Renderer *renderer, const Program *program, const Uniforms *uniforms) {
    if (!program->id) return;
    program_use(program);
    program_set(program, uniforms);
    resources_give(&renderer->tables, program);
}

/* Begins what is splatted. A preview has no light paths, because the next one may come at once. */
static bool begin_light(Renderer *renderer, const Frame *frame, Error *error) {
    const Camera *camera = &frame->camera;
    if (!chain_pass_begin(&renderer->chains, camera->width, camera->height, renderer->seed, error) ||
        !photon_pass_aim(&renderer->light, frame, !frame->coarse, error))
        return false;
    program_use(&renderer->program);
    photon_pass_give(&renderer->light, &renderer->program);
    return true;
}

/* Fills the tables for this frame, and when they are ready, sets all uniforms of the programs that stay the
 * same until the next frame. */
static bool set_up(Renderer *renderer, const Frame *frame, double seconds, bool (*stop)(void), Error *error) {
    Uniforms uniforms = {0};
    frame_uniforms(frame, &renderer->plan, renderer->seed, &uniforms);
    double *ready = &renderer->prepared;
    bool ok = resources_prepare_for(&renderer->tables, frame, &uniforms, seconds, stop, ready, error);
    if (ok && *ready == 1) give(renderer, &renderer->program, &uniforms);
    if (ok && *ready == 1) give(renderer, &renderer->image.program, &uniforms);
    if (ok && *ready == 1) give(renderer, &renderer->light.throwers, &uniforms);
    if (ok && *ready == 1) give(renderer, &renderer->light.photons, &uniforms);
    if (ok && *ready == 1) give(renderer, &renderer->chains.steps, &uniforms);
    if (ok && *ready == 1) give(renderer, &renderer->chains.keep, &uniforms);
    if (ok && *ready == 1) ok = begin_light(renderer, frame, error);
    uniforms_free(&uniforms);
    return ok && gl_check(renderer->gl, "setting up the pass", error);
}

/* The tables in a start: only begun if they need not be ready, or else filled while the watch goes on. */
static bool start(Renderer *renderer, const Frame *frame, const RenderParams *params, Error *error) {
    double seconds = params->in_steps ? 0.01 : params->watch ? SKY_WATCH_SECONDS : INFINITY;
    while (set_up(renderer, frame, seconds, NULL, error)) {
        if (!sky_watch_ask(params->watch, renderer->prepared, error)) break;
        if (params->in_steps || renderer->prepared == 1) return true;
    }
    return false;
}

/* Draws one pixel that no film takes in, because drivers compile a program when it first draws. */
static bool warm_up(Renderer *renderer, Error *error) {
    const Program *image = &renderer->image.program;
    image_pass_warm_up(&renderer->image, &renderer->film);
    if (image->id && !program_check(image, error)) return false;
    renderer_begin_group(renderer, 1);
    if (!program_check(&renderer->program, error)) return false;
    program_draw(&renderer->program, 0, 0, 1, 1);
    renderer->gl->Finish();
    return gl_check(renderer->gl, "drawing a first pixel", error);
}

/* Begins the picture if the tables are ready. */
static bool finish(Renderer *renderer, Error *error) {
    if (renderer->prepared < 1) return true;
    if (renderer->warm || renderer->film.samples) film_reset(&renderer->film);
    if (!renderer->warm && !warm_up(renderer, error)) return false;
    renderer->warm = true;
    return true;
}

static unsigned film_parts(const Renderer *renderer) {
    const Plan *plan = &renderer->plan;
    bool chains = plan->sequence.method->walks_chains;
    return (renderer->variance ? FILM_SCATTER : 0U) | (renderer->rejects && !chains ? FILM_REJECTS : 0U) |
           (plan_counts_searches(plan) && !chains ? FILM_SEARCH : 0U) |
           (plan_counts_chance(plan) ? FILM_CHANCE : 0U) |
           (plan->sun.method->traces_light || chains ? FILM_LIGHT : 0U);
}

/* Sets what follows from the plan and the scene's current values. */
static void follow(Renderer *renderer, const Frame *frame) {
    const Method *sun = renderer->plan.sun.method;
    const SceneValues *values = &frame->scene->values;
    double sun_deg = values->sun.elevation_deg;
    renderer->sky_bias_percent = bias_sky_percent(&renderer->plan.sky, sun_deg, &values->atmosphere);
    if (renderer->plan.sky.method->integrates)
        renderer->sky_bias_percent +=
            bias_further_percent(&renderer->plan.further, sun_deg, &values->atmosphere);
    renderer->sun_by_chance = sun->has_disk && !sun->samples_disk;
    renderer->camera = frame->camera;
    renderer->first_sample = frame->first_sample;
    Rectangle all = {0, 0, frame->camera.width, frame->camera.height};
    renderer->area = renderer->crop.width ? renderer->crop : all;
}

/* Where the picture of this frame may hold the sun's image. */
static bool find_image(const Renderer *renderer, Frame *frame, SunImage *image, Error *error) {
    double mirrors[MOST_HINTS][4];
    Uniforms uniforms = {0};
    frame_uniforms(frame, &renderer->plan, renderer->seed, &uniforms);
    bool ok = drawn_mirrors_ask(&renderer->tables, frame, &uniforms, mirrors, error);
    if (ok) *image = sun_image(frame);
    uniforms_free(&uniforms);
    frame->mirrors = NULL;
    return ok;
}

static bool create_parts(Renderer *renderer, const Context *context, const RenderParams *params,
                         Error *error) {
    int width = plan_width(params), height = plan_height(params);
    Camera camera = camera_of(params->scene, width, height);
    Frame frame = frame_of(&renderer->plan, params, &camera);
    SunImage image;
    follow(renderer, &frame);
    if (!create_program(renderer, context, params, error) || !list_files(renderer, params, error) ||
        !film_create(&renderer->film, context, width, height, film_parts(renderer), error) ||
        !create_tables(renderer, context, params, &frame, error) ||
        !image_pass_create(&renderer->image, context, &renderer->plan, error) ||
        !photon_pass_create(&renderer->light, context, &renderer->plan, params, error) ||
        !chain_pass_create(&renderer->chains, context, &renderer->plan, params, error) ||
        !find_image(renderer, &frame, &image, error) ||
        !image_pass_compile(&renderer->image, &image, &renderer->plan, params, error)) {
        return false;
    }
    renderer->sun_image = image;
    image_pass_begin(&renderer->image, &image, width, height);
    return start(renderer, &frame, params, error) && finish(renderer, error);
}

bool renderer_create(Renderer *renderer, const Context *context, const RenderParams *params, Error *error) {
    *renderer = (Renderer){.gl = &context->gl,
                           .seed = params->seed,
                           .crop = params->crop,
                           .variance = params->variance,
                           .rejects = params->rejects};
    if (!scene_check_size(plan_width(params), plan_height(params), error) ||
        !scene_check(params->scene, error) || !plan_make(&renderer->plan, params, context, error)) {
        goto fail;
    }
    renderer->group = renderer->plan.group_samples;
    /* A low guess for the first draw: paths have few hits, and the sky's loop always runs in full. */
    long likely = 10 + (renderer->plan.sky.table ? 0 : renderer->plan.sky.iterations);
    renderer->pixels_per_second = 1e8 / ((double)renderer->group * (double)likely);
    if (create_parts(renderer, context, params, error)) return true;
fail:
    renderer_destroy(renderer);
    return false;
}

static bool film_fits(const Renderer *renderer, int width, int height) {
    const Film *film = &renderer->film;
    return film->target.gl && film->width == width && film->height == height &&
           film->parts == film_parts(renderer);
}

/* If the new renderer has to wait for its tables, it keeps the picture of before. */
static bool recreate(Renderer *renderer, const Context *context, const RenderParams *params, Error *error) {
    Renderer next;
    if (!renderer_create(&next, context, params, error)) return false;
    Film film = next.film;
    if (next.prepared < 1 && renderer->film.samples && renderer->film.parts == film.parts &&
        film_fits(renderer, film.width, film.height)) {
        next.film = renderer->film;
        renderer->film = film;
    }
    renderer_destroy(renderer);
    *renderer = next;
    return true;
}

/* Creates a film of the frame's size if the renderer's film has another size or other parts; else `next` is
 * empty. */
static bool create_next_film(const Renderer *renderer, const Context *context, const Camera *camera,
                             Film *next, Error *error) {
    *next = (Film){0};
    return film_fits(renderer, camera->width, camera->height) ||
           film_create(next, context, camera->width, camera->height, film_parts(renderer), error);
}

bool renderer_restart(Renderer *renderer, const Context *context, const RenderParams *params, Error *error) {
    const Scene *scene = params->scene;
    int width = plan_width(params), height = plan_height(params);
    Plan plan = {.needs = renderer->plan.needs, .loop_limit = renderer->plan.loop_limit},
         before = renderer->plan;
    if (!scene_check_size(width, height, error) || !scene_check(scene, error) ||
        !plan_choose(&plan, params, context, error))
        return false;
    if (!plan_same_programs(&renderer->plan, &plan) || renderer->variance != params->variance ||
        renderer->rejects != params->rejects)
        return recreate(renderer, context, params, error);
    Camera camera = camera_of(scene, width, height);
    Frame frame = frame_of(&renderer->plan, params, &camera);
    unsigned seed = renderer->seed;
    Film next;
    renderer->plan = plan;
    renderer->seed = params->seed;
    SunImage image;
    if (!create_next_film(renderer, context, &camera, &next, error) ||
        !find_image(renderer, &frame, &image, error) ||
        !image_pass_compile(&renderer->image, &image, &plan, params, error) ||
        !start(renderer, &frame, params, error)) {
        film_destroy(&next);
        renderer->plan = before;
        renderer->seed = seed;
        return false;
    }
    follow(renderer, &frame);
    renderer->sun_image = image;
    image_pass_begin(&renderer->image, &image, width, height);
    if (next.target.gl) {
        film_destroy(&renderer->film);
        renderer->film = next;
    }
    renderer->pixels_per_second *= (double)renderer->group / plan.group_samples;
    /* Another picture. */
    renderer->pace.width = 0;
    renderer->group = plan.group_samples;
    renderer->row = 0;
    return finish(renderer, error);
}

bool renderer_prepare(Renderer *renderer, const RenderParams *params, double seconds, bool (*stop)(void),
                      Error *error) {
    if (renderer->prepared == 1) return true;
    Frame frame = frame_of(&renderer->plan, params, &renderer->camera);
    return set_up(renderer, &frame, seconds, stop, error) && finish(renderer, error);
}

void renderer_destroy(Renderer *renderer) {
    resources_destroy(&renderer->tables);
    film_destroy(&renderer->film);
    program_destroy(&renderer->program);
    image_pass_destroy(&renderer->image);
    photon_pass_destroy(&renderer->light);
    chain_pass_destroy(&renderer->chains);
    text_free(&renderer->source_files);
    *renderer = (Renderer){0};
}
