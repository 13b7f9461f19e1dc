#include "render/renderer.h"

#include "base/clock.h"
#include "base/text.h"
#include "choice/bias.h"
#include "gl/strips.h"
#include "render/inputs.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

bool renderer_flatten(const RenderParams *params, GlslSource *source, Error *error) {
    Plan plan;
    return plan_make(&plan, params, NULL, error) && plan_flatten(&plan, params, false, source, error);
}

static bool compile(Program *program, const Context *context, const GlslSource *source,
                    const RenderParams *params, Error *error) {
    if (program_create(program, &context->gl, source, error)) return true;
    /* A scene that breaks off shows its fault only in the text behind it. */
    if (strncmp(error->text, params->library, strlen(params->library)) == 0)
        error_prefix(error, "%s: ", params->scene->file->path);
    return false;
}

static bool create_program(Renderer *renderer, const Context *context, const Plan *plan,
                           const RenderParams *params, Error *error) {
    GlslSource source;
    if (!plan_flatten(plan, params, false, &source, error)) return false;
    bool ok = compile(&renderer->program, context, &source, params, error);
    for (int i = 0; i < source.file_count; i++)
        text_print(&renderer->source_files, "%s%s", i ? " " : "", source.files[i]);
    glsl_source_destroy(&source);
    return ok;
}

/* The program for the image of this sun, if it has one in the picture and is the first that has. */
static bool serve_image(Renderer *renderer, const Context *context, const SunTables *sun,
                        const RenderParams *params, Error *error) {
    return !sun->rectangle_count || renderer->image_program.id ||
           compile(&renderer->image_program, context, &renderer->image_source, params, error);
}

void renderer_set_parameters(const Program *program, const Scene *scene) {
    for (int i = 0; i < scene->file->parameter_count; i++) {
        const Parameter *parameter = &scene->file->parameters[i];
        const double *value = scene->values.parameters[i];
        switch (parameter->type) {
        case PARAMETER_SLIDER:
            program_set_float(program, parameter->name, value[0]);
            break;
        case PARAMETER_CHECKBOX:
            program_set_int(program, parameter->name, value[0] > 0);
            break;
        case PARAMETER_COLOR:
            program_set_vec3(program, parameter->name, value);
            break;
        }
    }
}

/* Tells one of the programs all that stays as it is. */
static bool set_up(Renderer *renderer, const Program *program, const Scene *scene, const SkyState *state,
                   Error *error) {
    Sky *sky = &renderer->sky;
    SkyPatches *patches = &renderer->patches;
    if (renderer->irradiance.gl &&
        !irradiance_use(&renderer->irradiance, patches, sky, program, state, error))
        return false;
    if (renderer->sampler.gl && !sky_sampler_use(&renderer->sampler, patches, sky, program, state, error))
        return false;
    if (!sky_use(sky, program, state, error)) return false;
    sun_use(&renderer->sun, program, scene, &renderer->camera);
    spheres_use(&renderer->spheres, program);
    camera_set(&renderer->camera, program);
    inputs_set(program, scene, renderer->camera.width, renderer->camera.height);
    renderer_set_parameters(program, scene);
    program_set_uint(program, "seed", renderer->seed);
    program_set_int(program, "max_hits", renderer->max_hits);
    return gl_check(renderer->gl, "setting up the pass", error);
}

/* What the light method looks up. */
static bool create_light(Renderer *renderer, const Context *context, const RenderParams *params,
                         const Plan *plan, Error *error) {
    bool irradiance = plan_controls(plan), sampler = plan_samples_sky(plan);
    if (!irradiance && !sampler) return true;
    return sky_patches_create(&renderer->patches, context, params->library, &plan->sky,
                              &params->scene->values.atmosphere, error) &&
           (!irradiance || irradiance_create(&renderer->irradiance, context, params->library, error)) &&
           (!sampler || sky_sampler_create(&renderer->sampler, context, error));
}

static bool create_parts(Renderer *renderer, const Context *context, const RenderParams *params,
                         const Plan *plan, Error *error) {
    const Scene *scene = params->scene;
    const Camera *camera = &renderer->camera;
    renderer->parts = (params->variance ? FILM_SCATTER : 0U) | (plan->needs.search ? FILM_SEARCH : 0U) |
                      (plan_counts_chance(plan) ? FILM_CHANCE : 0U);
    bool image = plan->sun.method->draws_image;
    if (!create_program(renderer, context, plan, params, error) ||
        (image && !plan_flatten(plan, params, true, &renderer->image_source, error)) ||
        !film_create(&renderer->film, context, camera->width, camera->height, renderer->parts, error) ||
        !sky_create(&renderer->sky, context, params->library, &plan->sky, &scene->values.atmosphere, error) ||
        !sun_create(&renderer->sun, context, &plan->sun, scene, camera, error) ||
        !spheres_create(&renderer->spheres, context, params->library, scene, error) ||
        !serve_image(renderer, context, &renderer->sun, params, error)) {
        return false;
    }
    return create_light(renderer, context, params, plan, error);
}

static void remember_spheres(Renderer *renderer, const Scene *scene) {
    memcpy(renderer->spheres_made_for, scene->values.parameters, sizeof scene->values.parameters);
    renderer->spheres_time_s = scene->values.time_s;
}

bool renderer_use(Renderer *renderer, const Scene *scene, Error *error) {
    SkyState state = {scene->values.atmosphere, scene->values.sun};
    return set_up(renderer, &renderer->program, scene, &state, error) &&
           (!renderer->image_program.id || set_up(renderer, &renderer->image_program, scene, &state, error));
}

/* What the plan says. */
static void follow_plan(Renderer *renderer, const Plan *plan) {
    renderer->light = plan->light;
    renderer->sequence = plan->sequence;
    renderer->sun_disk = plan->sun;
    const Method *sun = plan->sun.method;
    renderer->sun_by_chance = sun->has_disk && !sun->samples_disk;
    renderer->needs = plan->needs;
    renderer->max_hits = plan->max_hits;
    renderer->group_samples = renderer->group = plan->group_samples;
    /* For the first draw, a guess on the low side: hits are few, the sky's loop is run in full. */
    long likely = 10 + (plan->sky.table ? 0 : plan->sky.iterations);
    renderer->pixels_per_second = 1e8 / ((double)renderer->group_samples * (double)likely);
}

static void begin(Renderer *renderer, const Program *program, unsigned group) {
    program_use(program);
    program_set_uint(program, "group_samples", group);
    program_set_int(program, "iFrame", (int)(renderer->film.samples / renderer->group_samples));
    film_begin(&renderer->film, program);
}

/* A pixel that no film ever takes in: drivers compile a program when it draws first. */
static bool warm_up(Renderer *renderer, Error *error) {
    const Program *programs[] = {&renderer->program, &renderer->image_program};
    for (int i = 0; i < 2; i++) {
        if (!programs[i]->id) continue;
        begin(renderer, programs[i], 1);
        program_draw(programs[i], 0, 0, 1, 1);
    }
    renderer->gl->Finish();
    return gl_check(renderer->gl, "drawing a first pixel", error);
}

bool renderer_create(Renderer *renderer, const Context *context, const RenderParams *params, Error *error) {
    const Scene *scene = params->scene;
    int width = plan_width(params), height = plan_height(params);
    Plan plan;
    *renderer =
        (Renderer){.gl = &context->gl, .seed = params->seed, .ozone = scene->values.atmosphere.ozone > 0};
    if (!scene_check_size(width, height, error) || !scene_check(scene, error) ||
        !plan_make(&plan, params, context, error))
        goto fail;
    follow_plan(renderer, &plan);
    renderer->sky_bias_percent =
        bias_sky_percent(&plan.sky, scene->values.sun.elevation_deg, &scene->values.atmosphere);
    remember_spheres(renderer, scene);
    renderer->camera = camera_of(scene, width, height);
    if (create_parts(renderer, context, params, &plan, error) && renderer_use(renderer, scene, error) &&
        warm_up(renderer, error))
        return true;
fail:
    renderer_destroy(renderer);
    return false;
}

static bool compiled_for(const Renderer *renderer, const Plan *plan, const RenderParams *params) {
    return strcmp(renderer->sky.choice.text, plan->sky.text) == 0 &&
           strcmp(renderer->light.text, plan->light.text) == 0 &&
           strcmp(renderer->sequence.text, plan->sequence.text) == 0 &&
           strcmp(renderer->sun_disk.text, plan->sun.text) == 0 &&
           renderer->ozone == (params->scene->values.atmosphere.ozone > 0);
}

static bool recreate(Renderer *renderer, const Context *context, const RenderParams *params, Error *error) {
    Renderer next;
    if (!renderer_create(&next, context, params, error)) return false;
    renderer_destroy(renderer);
    *renderer = next;
    return true;
}

/* An empty film of the camera's size. */
static bool clear_film(Renderer *renderer, const Context *context, const Camera *camera, Error *error) {
    Film *film = &renderer->film;
    if (film->target.gl && film->width == camera->width && film->height == camera->height &&
        film->parts == renderer->parts) {
        film_reset(film);
        return true;
    }
    Film next;
    if (!film_create(&next, context, camera->width, camera->height, renderer->parts, error)) return false;
    film_destroy(film);
    *film = next;
    return true;
}

/* Spheres that the scene makes itself follow its parameters, and its time. */
static bool refill_spheres(Renderer *renderer, const Scene *scene, Error *error) {
    bool same =
        memcmp(renderer->spheres_made_for, scene->values.parameters, sizeof scene->values.parameters) == 0 &&
        memcmp(&renderer->spheres_time_s, &scene->values.time_s, sizeof scene->values.time_s) == 0;
    if (!renderer->spheres.gl || same) return true;
    if (!spheres_fill(&renderer->spheres, scene, error)) return false;
    remember_spheres(renderer, scene);
    return true;
}

bool renderer_restart(Renderer *renderer, const Context *context, const RenderParams *params, Error *error) {
    const Scene *scene = params->scene;
    int width = plan_width(params), height = plan_height(params);
    Plan plan = {.needs = renderer->needs};
    if (!scene_check_size(width, height, error) || !scene_check(scene, error) ||
        !plan_choose_methods(&plan, params, error)) {
        return false;
    }
    if (!compiled_for(renderer, &plan, params)) return recreate(renderer, context, params, error);
    Camera camera = camera_of(scene, width, height);
    SunTables sun;
    if (!sun_create(&sun, context, &plan.sun, scene, &camera, error)) return false;
    if (!serve_image(renderer, context, &sun, params, error) || !refill_spheres(renderer, scene, error) ||
        !clear_film(renderer, context, &camera, error)) {
        sun_destroy(&sun);
        return false;
    }
    sun_destroy(&renderer->sun);
    renderer->sun = sun;
    renderer->camera = camera;
    renderer->sky_bias_percent =
        bias_sky_percent(&plan.sky, scene->values.sun.elevation_deg, &scene->values.atmosphere);
    renderer->seed = params->seed;
    renderer->row = 0;
    return renderer_use(renderer, scene, error);
}

void renderer_destroy(Renderer *renderer) {
    irradiance_destroy(&renderer->irradiance);
    sky_sampler_destroy(&renderer->sampler);
    sky_patches_destroy(&renderer->patches);
    sun_destroy(&renderer->sun);
    spheres_destroy(&renderer->spheres);
    sky_destroy(&renderer->sky);
    film_destroy(&renderer->film);
    program_destroy(&renderer->program);
    program_destroy(&renderer->image_program);
    glsl_source_destroy(&renderer->image_source);
    text_free(&renderer->source_files);
    *renderer = (Renderer){0};
}

static int largest(int a, int b) {
    return a > b ? a : b;
}

/* The pixels of the regions that may hold the sun's own image, once more and now with it. */
static void draw_sun_image(Renderer *renderer, const Rectangle *regions, int count, unsigned group) {
    if (!renderer->sun.rectangle_count) return;
    begin(renderer, &renderer->image_program, group);
    for (int i = 0; i < renderer->sun.rectangle_count * count; i++) {
        const Rectangle *a = &renderer->sun.rectangles[i / count], *b = &regions[i % count];
        int x = largest(a->x, b->x), y = largest(a->y, b->y);
        int right = -largest(-a->x - a->width, -b->x - b->width);
        int bottom = -largest(-a->y - a->height, -b->y - b->height);
        if (right > x && bottom > y) program_draw(&renderer->image_program, x, y, right - x, bottom - y);
    }
    renderer->gl->Finish();
}

/* False when stopped. */
static bool draw_group(Renderer *renderer, const Rectangle *regions, int count, unsigned group,
                       bool (*stop)(void)) {
    begin(renderer, &renderer->program, group);
    if (!strips_draw(&renderer->program, regions, count, &renderer->pixels_per_second, stop)) return false;
    draw_sun_image(renderer, regions, count, group);
    return true;
}

bool renderer_pass(Renderer *renderer, uint64_t samples, bool (*stop)(void), Error *error) {
    Film *film = &renderer->film;
    Rectangle all = {0, 0, film->width, film->height};
    unsigned group = samples < renderer->group_samples ? (unsigned)samples : renderer->group_samples;
    bool stopped = !draw_group(renderer, &all, 1, group, stop);
    if (!gl_check(renderer->gl, "drawing a pass", error)) return false;
    if (!stopped || film->samples == 0) film_commit(film, group);
    return true;
}

bool renderer_refine(Renderer *renderer, const Rectangle *regions, int count, unsigned samples,
                     bool (*stop)(void), bool *stopped, Error *error) {
    *stopped = !draw_group(renderer, regions, count, samples, stop);
    if (!*stopped) film_commit(&renderer->film, 0);
    return gl_check(renderer->gl, "refining regions", error);
}

static void bind_textures(const Renderer *renderer) {
    sky_bind(&renderer->sky);
    sun_bind(&renderer->sun);
    irradiance_bind(&renderer->irradiance);
    sky_sampler_bind(&renderer->sampler);
    spheres_bind(&renderer->spheres);
}

bool renderer_advance(Renderer *renderer, uint64_t samples, double seconds, bool (*stop)(void),
                      Error *error) {
    Film *film = &renderer->film;
    Rectangle all = {0, 0, film->width, film->height};
    if (renderer->row == 0) {
        unsigned last = renderer->group;
        renderer->group = samples < renderer->group_samples ? (unsigned)samples : renderer->group_samples;
        renderer->pixels_per_second *= (double)last / renderer->group;
    }
    bind_textures(renderer);
    begin(renderer, &renderer->program, renderer->group);
    strips_draw_for(&renderer->program, film->width, film->height, &renderer->row,
                    &renderer->pixels_per_second, seconds, stop);
    if (renderer->row == film->height) {
        draw_sun_image(renderer, &all, 1, renderer->group);
        film_commit(film, renderer->group);
        renderer->row = 0;
    }
    return gl_check(renderer->gl, "drawing a pass", error);
}
