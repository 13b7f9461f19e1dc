#include "render/renderer.h"

#include "base/clock.h"
#include "base/text.h"
#include "render/auto.h"
#include "render/bias.h"
#include "render/inputs.h"
#include "render/strips.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    MOST_GROUP_SAMPLES = 16,
    /* llvmpipe ends all loops of a shader after this many iterations together, without an error. */
    LOOP_LIMIT = 65535,
    /* "Unlimited" for the loop's sake: Russian roulette lets a path come so far with a probability below
       1e-22. */
    UNLIMITED_HITS = 1000,
    /* Of one march() and one hit_spheres(): some 20 are usual, the most are MARCH_STEPS
       (glsl/shape/march.glsl) and SPHERES_STEPS (glsl/shape/spheres.glsl). What goes beyond all loops
       together is noticed (glsl/pass/search.glsl) and counted. */
    MARCH_ITERATIONS = 200,
    SPHERES_ITERATIONS = 200
};

typedef struct Methods {
    MethodChoice sky, light, sequence, sun;
} Methods;

/* What a scene's own text and its includes say, so that nothing more is compiled and errors are about the
 * scene. */
typedef struct SceneNeeds {
    bool search;            /* whether its rays search by loops (glsl/shape/search.glsl) */
    long search_iterations; /* of one ray */
    bool emits;             /* whether one of its materials does */
    unsigned inputs;        /* render/inputs.h */
} SceneNeeds;

static bool uses_control(const Methods *methods) {
    return strcmp(methods->light.method->name, "control") == 0;
}

static bool uses_sky_sampler(const Methods *methods) {
    return strcmp(methods->light.method->name, "mis") == 0;
}

/* Loop iterations at one hit, with those of its rays' searches, and the bounds, mirror spheres and emitters
 * that it looks for. */
static long hit_iterations(const Methods *methods, const SceneNeeds *needs, const Scene *scene) {
    bool sun = strcmp(methods->sun.method->name, "sampled") == 0;
    long emitters = needs->emits ? scene->emitter_count : 0;
    long rays = 1 + (sun ? 1 : 0) + (sun && scene->mirror_count ? 2 : 0) + (emitters ? 1 : 0);
    long bounds = uses_control(methods) ? (emitters ? 3L : 2L) * scene->bound_count : 0;
    long mirrors = sun && scene->mirror_count ? 6 + 5L * scene->mirror_count : 0;
    return 1 + rays * needs->search_iterations + bounds + mirrors + 3 * emitters;
}

/* Where much is looked for at a hit, "unlimited" is as many hits as the loops allow. */
static bool choose_group(Renderer *renderer, const Methods *methods, const SceneNeeds *needs,
                         const RenderParams *params, Error *error) {
    const MethodChoice *sky = &methods->sky;
    long hit = hit_iterations(methods, needs, params->scene);
    long others = 1 + (sky->table ? 0 : sky->iterations) * (uses_control(methods) ? 2 : 1);
    long most = (LOOP_LIMIT - others) / hit - 1;
    if (!params->max_hits && hit > 1 && most > 16 && most < renderer->max_hits)
        renderer->max_hits = (int)most;
    long iterations = others + (renderer->max_hits + 1L) * hit;
    if (iterations > LOOP_LIMIT || sky->iterations > LOOP_LIMIT) {
        return error_set(error, STATUS_USAGE,
                         "--sky %s with --light %s and %d surface hits needs %ld loop iterations a sample; "
                         "the limit is %d",
                         sky->text, methods->light.text, renderer->max_hits,
                         iterations > LOOP_LIMIT ? iterations : sky->iterations, LOOP_LIMIT);
    }
    renderer->group_samples = MOST_GROUP_SAMPLES;
    while (renderer->group_samples * iterations > LOOP_LIMIT) renderer->group_samples /= 2;
    renderer->group = renderer->group_samples;
    /* For the first draw, a guess on the low side: hits are few, the sky's loop is run in full. */
    long likely = 10 + (sky->table ? 0 : sky->iterations);
    renderer->pixels_per_second = 1e8 / ((double)renderer->group_samples * (double)likely);
    return true;
}

static bool choose_methods(Methods *methods, const RenderParams *params, int width, int height,
                           Error *error) {
    const Scene *scene = params->scene;
    const char *sky = params->sky ? params->sky : scene->sky[0] ? scene->sky : NULL;
    AutoWish wish = {.error_percent = params->error_percent,
                     .samples = (double)params->samples,
                     .pixels = (double)width * height,
                     .sun_elevation_deg = scene->sun_elevation_deg,
                     .atmosphere = &scene->atmosphere,
                     .bounds = scene->bound_count > 0};
    if (!auto_sky(&methods->sky, sky, &wish, error)) {
        if (params->sky) return false;
        error->status = STATUS_SCENE;
        return error_prefix(error, "%s:%d: ", scene->path, scene->sky_line);
    }
    return auto_light(&methods->light, params->light, &methods->sky, &wish, error) &&
           method_choose(&methods->sequence, METHOD_SEQUENCE, params->sequence, error) &&
           sun_choose(&methods->sun, params->sun_disk, scene, error);
}

static int picture_width(const RenderParams *params) {
    return params->width ? params->width : params->scene->width;
}

static int picture_height(const RenderParams *params) {
    return params->height ? params->height : params->scene->height;
}

/* `calls` of hit_spheres(). */
static bool check_spheres(const Scene *scene, const GlslSource *source, int calls, Error *error) {
    if (calls && !scene->spheres[0]) {
        return error_set(error, STATUS_SCENE,
                         "%s:1: hit_spheres() needs `//@ spheres COUNT` or `//@ spheres FILE.csv`",
                         scene->path);
    }
    if (scene->spheres[0] && scene_sphere_count(scene) >= 0 && !glsl_source_defines(source, "scene_sphere")) {
        return error_set(error, STATUS_SCENE, "%s:%d: missing function: vec4 scene_sphere(int i)",
                         scene->path, scene->spheres_line);
    }
    return true;
}

static bool read_needs(const RenderParams *params, SceneNeeds *needs, Error *error) {
    static const char *const functions[] = {"scene_intersect", "scene_material"};
    static const char *const signatures[] = {"void scene_intersect(Ray ray, INOUT(Hit) hit)",
                                             "Material scene_material(Hit hit)"};
    const char *path = params->scene->path;
    GlslSource source;
    bool ok = true;
    if (!glsl_source_create(&source, params->library, path, NULL, error)) return false;
    for (int i = 0; ok && i < 2; i++) {
        if (glsl_source_defines(&source, functions[i])) continue;
        ok = error_set(error, STATUS_SCENE, "%s:1: missing function: %s", path, signatures[i]);
    }
    int marches = glsl_source_calls(&source, "march"), spheres = glsl_source_calls(&source, "hit_spheres");
    if (ok) ok = check_spheres(params->scene, &source, spheres, error);
    *needs = (SceneNeeds){.search = glsl_source_includes(&source, "shape/search.glsl"),
                          .search_iterations =
                              (long)marches * MARCH_ITERATIONS + (long)spheres * SPHERES_ITERATIONS,
                          .emits = glsl_source_emits(&source),
                          .inputs = inputs_wanted(&source)};
    glsl_source_destroy(&source);
    return ok;
}

/* The spheres that a scene names as GLSL, their words as they are: numbers, or the uniforms of sliders. */
static void write_spheres(Text *text, const char *count_name, const char *function,
                          const NamedSphere *spheres, int count) {
    text_print(text, "const int %s = %d;\nvec4 %s(int i) {\n", count_name, count, function);
    for (int i = 0; i < count; i++) {
        text_print(text, "    if (i == %d) return vec4(", i);
        for (int k = 0; k < 4; k++) text_print(text, "%sfloat(%s)", k ? ", " : "", spheres[i].words[k]);
        text_print(text, ");\n");
    }
    text_print(text, "    return vec4(0.0);\n}");
}

/* `image`: with the sun's own image. */
static bool flatten(const Methods *methods, const SceneNeeds *needs, const RenderParams *params, bool image,
                    GlslSource *source, Error *error) {
    const Scene *scene = params->scene;
    GlslSlot slots[SKY_SLOTS + SUN_SLOTS + 11] = {{0}}, *slot = slots + SKY_SLOTS + SUN_SLOTS;
    SkySlotText text;
    Text bounds = {0}, mirrors = {0}, emitters = {0}, inputs = {0};
    const char *emission = !needs->emits          ? "emission/none.glsl"
                           : scene->emitter_count ? "emission/sampled.glsl"
                                                  : "emission/chance.glsl";
    write_spheres(&bounds, "SCENE_BOUNDS", "scene_bound", scene->bounds, scene->bound_count);
    write_spheres(&mirrors, "MIRROR_SPHERES", "mirror_sphere", scene->mirrors, scene->mirror_count);
    write_spheres(&emitters, "EMITTER_SPHERES", "emitter_sphere", scene->emitters, scene->emitter_count);
    sky_slots(&methods->sky, &scene->atmosphere, slots, &text);
    sun_slots(&methods->sun, scene, image, text_string(&mirrors), slots + SKY_SLOTS);
    slot[0] = (GlslSlot){"sequence", methods->sequence.method->file, NULL};
    slot[1] = (GlslSlot){"light", methods->light.method->file, NULL};
    slot[2] = (GlslSlot){"scene", scene->path, NULL};
    slot[3] = (GlslSlot){"bounds", NULL, text_string(&bounds)};
    slot[4] = (GlslSlot){"scatter", params->variance ? "pass/scatter.glsl" : "pass/scatter_none.glsl", NULL};
    slot[5] = (GlslSlot){"search", needs->search ? "pass/search.glsl" : "pass/search_none.glsl", NULL};
    slot[6] = (GlslSlot){"spheres", spheres_slot(scene), NULL};
    slot[7] = (GlslSlot){"emission", emission, NULL};
    slot[8] = (GlslSlot){"emitter-spheres", NULL, text_string(&emitters)};
    inputs_declare(needs->inputs, &inputs);
    slot[9] = (GlslSlot){"inputs", NULL, text_string(&inputs)};
    bool ok = glsl_source_create(source, params->library, "pass/trace.glsl", slots, error);
    text_free(&bounds);
    text_free(&mirrors);
    text_free(&emitters);
    text_free(&inputs);
    return ok;
}

bool renderer_flatten(const RenderParams *params, GlslSource *source, Error *error) {
    Methods methods;
    SceneNeeds needs;
    return read_needs(params, &needs, error) &&
           choose_methods(&methods, params, picture_width(params), picture_height(params), error) &&
           flatten(&methods, &needs, params, false, source, error);
}

static bool create_program(Program *program, const Context *context, const Methods *methods,
                           const SceneNeeds *needs, const RenderParams *params, bool image, Text *files,
                           Error *error) {
    GlslSource source;
    if (!flatten(methods, needs, params, image, &source, error)) return false;
    bool ok = program_create(program, &context->gl, &source, error);
    /* A scene that breaks off shows its fault only in the text behind it. */
    if (!ok && strncmp(error->text, params->library, strlen(params->library)) == 0)
        error_prefix(error, "%s: ", params->scene->path);
    for (int i = 0; files && i < source.file_count; i++)
        text_print(files, "%s%s", i ? " " : "", source.files[i]);
    glsl_source_destroy(&source);
    return ok;
}

void renderer_set_parameters(const Program *program, const Scene *scene) {
    for (int i = 0; i < scene->parameter_count; i++) {
        const Parameter *parameter = &scene->parameters[i];
        switch (parameter->type) {
        case PARAMETER_SLIDER:
            program_set_float(program, parameter->name, parameter->value[0]);
            break;
        case PARAMETER_CHECKBOX:
            program_set_int(program, parameter->name, parameter->value[0] > 0);
            break;
        case PARAMETER_COLOR:
            program_set_vec3(program, parameter->name, parameter->value);
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
                         const Methods *methods, Error *error) {
    bool irradiance = uses_control(methods), sampler = uses_sky_sampler(methods);
    if (!irradiance && !sampler) return true;
    return sky_patches_create(&renderer->patches, context, params->library, &methods->sky,
                              &params->scene->atmosphere, error) &&
           (!irradiance || irradiance_create(&renderer->irradiance, context, params->library, error)) &&
           (!sampler || sky_sampler_create(&renderer->sampler, context, error));
}

static bool create_parts(Renderer *renderer, const Context *context, const RenderParams *params,
                         const Methods *methods, const SceneNeeds *needs, Error *error) {
    const Scene *scene = params->scene;
    const Camera *camera = &renderer->camera;
    renderer->parts = (params->variance ? FILM_SCATTER : 0U) | (needs->search ? FILM_SEARCH : 0U);
    if (!create_program(&renderer->program, context, methods, needs, params, false, &renderer->source_files,
                        error) ||
        !film_create(&renderer->film, context, camera->width, camera->height, renderer->parts, error) ||
        !sky_create(&renderer->sky, context, params->library, &methods->sky, &scene->atmosphere, error) ||
        !sun_create(&renderer->sun, context, &methods->sun, scene, camera, error) ||
        !spheres_create(&renderer->spheres, context, params->library, scene, error)) {
        return false;
    }
    if (renderer->sun.rectangle_count &&
        !create_program(&renderer->image_program, context, methods, needs, params, true, NULL, error)) {
        return false;
    }
    return create_light(renderer, context, params, methods, error);
}

static void remember_spheres(Renderer *renderer, const Scene *scene) {
    memcpy(renderer->spheres_made_for, scene->parameters, sizeof scene->parameters);
    renderer->spheres_time_s = scene->time_s;
}

bool renderer_use(Renderer *renderer, const Scene *scene, Error *error) {
    SkyState state = {scene->atmosphere, scene->sun_elevation_deg, scene->sun_azimuth_deg};
    return set_up(renderer, &renderer->program, scene, &state, error) &&
           (!renderer->image_program.id || set_up(renderer, &renderer->image_program, scene, &state, error));
}

bool renderer_create(Renderer *renderer, const Context *context, const RenderParams *params, Error *error) {
    const Scene *scene = params->scene;
    int width = picture_width(params), height = picture_height(params);
    Methods methods;
    SceneNeeds needs;
    *renderer = (Renderer){.gl = &context->gl,
                           .seed = params->seed,
                           .max_hits = params->max_hits ? params->max_hits : UNLIMITED_HITS,
                           .ozone = scene->atmosphere.ozone > 0};
    if (!scene_check_size(width, height, error) || !scene_check(scene, error) ||
        !read_needs(params, &needs, error) || !choose_methods(&methods, params, width, height, error) ||
        !choose_group(renderer, &methods, &needs, params, error)) {
        goto fail;
    }
    renderer->sky_bias_percent = bias_sky_percent(&methods.sky, scene->sun_elevation_deg, &scene->atmosphere);
    renderer->inputs = needs.inputs;
    remember_spheres(renderer, scene);
    renderer->light = methods.light;
    renderer->sequence = methods.sequence;
    renderer->sun_disk = methods.sun;
    renderer->camera = camera_of(scene, width, height);
    if (create_parts(renderer, context, params, &methods, &needs, error) &&
        renderer_use(renderer, scene, error))
        return true;
fail:
    renderer_destroy(renderer);
    return false;
}

static bool compiled_for(const Renderer *renderer, const Methods *methods, const RenderParams *params) {
    return strcmp(renderer->sky.choice.text, methods->sky.text) == 0 &&
           strcmp(renderer->light.text, methods->light.text) == 0 &&
           strcmp(renderer->sequence.text, methods->sequence.text) == 0 &&
           strcmp(renderer->sun_disk.text, methods->sun.text) == 0 &&
           renderer->ozone == (params->scene->atmosphere.ozone > 0);
}

static bool recreate(Renderer *renderer, const Context *context, const RenderParams *params, Error *error) {
    Renderer next;
    if (!renderer_create(&next, context, params, error)) return false;
    renderer_destroy(renderer);
    *renderer = next;
    return true;
}

/* An empty film of the camera's size. */
static bool clear_film(Renderer *renderer, const Context *context, Error *error) {
    const Camera *camera = &renderer->camera;
    Film *film = &renderer->film;
    if (film->target.gl && film->width == camera->width && film->height == camera->height &&
        film->parts == renderer->parts) {
        film_reset(film);
        return true;
    }
    film_destroy(film);
    return film_create(film, context, camera->width, camera->height, renderer->parts, error);
}

/* Spheres that the scene makes itself follow its parameters, and its time. */
static bool refill_spheres(Renderer *renderer, const Scene *scene, Error *error) {
    bool same = memcmp(renderer->spheres_made_for, scene->parameters, sizeof scene->parameters) == 0 &&
                memcmp(&renderer->spheres_time_s, &scene->time_s, sizeof scene->time_s) == 0;
    if (!renderer->spheres.gl || same) return true;
    if (!spheres_fill(&renderer->spheres, scene, error)) return false;
    remember_spheres(renderer, scene);
    return true;
}

/* The sun as it stands now, and the program for its image where there is one for the first time. */
static bool move_sun(Renderer *renderer, const Context *context, const Methods *methods,
                     const RenderParams *params, Error *error) {
    SceneNeeds needs;
    sun_destroy(&renderer->sun);
    if (!sun_create(&renderer->sun, context, &methods->sun, params->scene, &renderer->camera, error))
        return false;
    return !renderer->sun.rectangle_count || renderer->image_program.id ||
           (read_needs(params, &needs, error) &&
            create_program(&renderer->image_program, context, methods, &needs, params, true, NULL, error));
}

bool renderer_restart(Renderer *renderer, const Context *context, const RenderParams *params, Error *error) {
    const Scene *scene = params->scene;
    int width = picture_width(params), height = picture_height(params);
    Methods methods;
    if (!scene_check_size(width, height, error) || !scene_check(scene, error) ||
        !choose_methods(&methods, params, width, height, error)) {
        return false;
    }
    if (!compiled_for(renderer, &methods, params)) return recreate(renderer, context, params, error);
    if (!refill_spheres(renderer, scene, error)) return false;
    renderer->camera = camera_of(scene, width, height);
    renderer->sky_bias_percent = bias_sky_percent(&methods.sky, scene->sun_elevation_deg, &scene->atmosphere);
    renderer->seed = params->seed;
    renderer->row = 0;
    return clear_film(renderer, context, error) && move_sun(renderer, context, &methods, params, error) &&
           renderer_use(renderer, scene, error);
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
    text_free(&renderer->source_files);
    *renderer = (Renderer){0};
}

static void begin(Renderer *renderer, const Program *program, unsigned group) {
    program_use(program);
    program_set_uint(program, "group_samples", group);
    program_set_int(program, "iFrame", (int)(renderer->film.samples / renderer->group_samples));
    film_begin(&renderer->film, program);
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

bool renderer_refine(Renderer *renderer, const Rectangle *regions, int count, uint64_t samples,
                     double deadline, bool (*stop)(void), uint64_t *taken, Error *error) {
    *taken = 0;
    film_keep(&renderer->film);
    while (*taken < samples && clock_seconds() < deadline) {
        uint64_t left = samples - *taken;
        unsigned group = left < renderer->group_samples ? (unsigned)left : renderer->group_samples;
        if (!draw_group(renderer, regions, count, group, stop)) break;
        film_commit(&renderer->film, 0);
        *taken += group;
    }
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
