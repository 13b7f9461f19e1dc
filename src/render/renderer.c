#include "render/renderer.h"

#include "base/clock.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    MOST_GROUP_SAMPLES = 16,
    /* llvmpipe ends all loops of a shader after this many iterations together, without an error. */
    LOOP_LIMIT = 65535,
    /* "Unlimited" for the loop's sake: Russian roulette lets a path come so far with a probability below
       1e-22. */
    UNLIMITED_HITS = 1000
};

static const double degree = 3.14159265358979323846 / 180;

typedef struct Methods {
    MethodChoice sky, light, sequence;
} Methods;

static bool uses_control(const Methods *methods) {
    return strcmp(methods->light.method->name, "control") == 0;
}

/* Loop iterations of one sample: itself, its hits with the bounds at each, and the sky. */
static long sample_iterations(const Methods *methods, const Scene *scene, int max_hits) {
    bool control = uses_control(methods);
    long hit = 1 + (control ? 2L * scene->bound_count : 0);
    long sky = methods->sky.table ? 0 : methods->sky.iterations;
    return 1 + (max_hits + 1L) * hit + sky * (control ? 2 : 1);
}

static bool choose_group(Renderer *renderer, const Methods *methods, const Scene *scene, int width,
                         Error *error) {
    const MethodChoice *sky = &methods->sky;
    long iterations = sample_iterations(methods, scene, renderer->max_hits);
    if (iterations > LOOP_LIMIT || sky->iterations > LOOP_LIMIT) {
        return error_set(error, STATUS_USAGE,
                         "--sky %s with --light %s and %d surface hits needs %ld loop iterations a sample; "
                         "the limit is %d",
                         sky->text, methods->light.text, renderer->max_hits,
                         iterations > LOOP_LIMIT ? iterations : sky->iterations, LOOP_LIMIT);
    }
    renderer->group_samples = MOST_GROUP_SAMPLES;
    while (renderer->group_samples * iterations > LOOP_LIMIT) renderer->group_samples /= 2;
    /* For the first draw, a guess on the low side: hits are few, the sky's loop is run in full. */
    long likely = 10 + (sky->table ? 0 : sky->iterations);
    renderer->rows_per_second = 1e8 / ((double)renderer->group_samples * (double)likely * width);
    return true;
}

static bool choose_methods(Methods *methods, const RenderParams *params, int width, int height,
                           Error *error) {
    const Scene *scene = params->scene;
    const Atmosphere *a = &scene->atmosphere;
    const char *sky = params->sky ? params->sky : scene->sky[0] ? scene->sky : NULL;
    double paths = params->samples ? (double)params->samples * width * height : INFINITY;
    bool above_air = a->observer_height_m > a->top_radius_m - a->planet_radius_m;
    if (!method_choose_sky(&methods->sky, sky, paths, above_air, error)) {
        if (params->sky) return false;
        error->status = STATUS_SCENE;
        return error_prefix(error, "%s:%d: ", scene->path, scene->sky_line);
    }
    return method_choose(&methods->light, METHOD_LIGHT, params->light, error) &&
           method_choose(&methods->sequence, METHOD_SEQUENCE, params->sequence, error);
}

static int picture_width(const RenderParams *params) {
    return params->width ? params->width : params->scene->width;
}

static int picture_height(const RenderParams *params) {
    return params->height ? params->height : params->scene->height;
}

/* The functions that a scene owes, looked for in its own text, so that the error is about the scene. */
static bool check_scene_functions(const RenderParams *params, Error *error) {
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
    glsl_source_destroy(&source);
    return ok;
}

/* The scene's bounds as GLSL, their words as they are: numbers, or the uniforms of sliders. */
static void write_bounds(const Scene *scene, Text *text) {
    text_print(text, "const int SCENE_BOUNDS = %d;\nvec4 scene_bound(int i) {\n", scene->bound_count);
    for (int i = 0; i < scene->bound_count; i++) {
        text_print(text, "    if (i == %d) return vec4(", i);
        for (int k = 0; k < 4; k++) text_print(text, "%sfloat(%s)", k ? ", " : "", scene->bounds[i].words[k]);
        text_print(text, ");\n");
    }
    text_print(text, "    return vec4(0.0);\n}");
}

static bool flatten(const Methods *methods, const RenderParams *params, GlslSource *source, Error *error) {
    GlslSlot slots[SKY_SLOTS + 5] = {{0}};
    SkySlotText text;
    Text bounds = {0};
    write_bounds(params->scene, &bounds);
    sky_slots(&methods->sky, &params->scene->atmosphere, slots, &text);
    slots[SKY_SLOTS] = (GlslSlot){"sequence", methods->sequence.method->file, NULL};
    slots[SKY_SLOTS + 1] = (GlslSlot){"light", methods->light.method->file, NULL};
    slots[SKY_SLOTS + 2] = (GlslSlot){"scene", params->scene->path, NULL};
    slots[SKY_SLOTS + 3] = (GlslSlot){"bounds", NULL, text_string(&bounds)};
    bool ok = check_scene_functions(params, error) &&
              glsl_source_create(source, params->library, "pass/trace.glsl", slots, error);
    text_free(&bounds);
    return ok;
}

bool renderer_flatten(const RenderParams *params, GlslSource *source, Error *error) {
    Methods methods;
    return choose_methods(&methods, params, picture_width(params), picture_height(params), error) &&
           flatten(&methods, params, source, error);
}

static bool create_program(Renderer *renderer, const Methods *methods, const RenderParams *params,
                           Error *error) {
    GlslSource source;
    if (!flatten(methods, params, &source, error)) return false;
    bool ok = program_create(&renderer->program, renderer->gl, &source, error);
    /* A scene that breaks off shows its fault only in the text behind it. */
    if (!ok && strncmp(error->text, params->library, strlen(params->library)) == 0)
        error_prefix(error, "%s: ", params->scene->path);
    for (int i = 0; i < source.file_count; i++) {
        size_t used = strlen(renderer->source_files);
        snprintf(renderer->source_files + used, sizeof renderer->source_files - used, "%s%s", i ? " " : "",
                 source.files[i]);
    }
    glsl_source_destroy(&source);
    return ok;
}

static void cross(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++) out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void scale_to(double v[3], double length) {
    double factor = length / sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; i++) v[i] *= factor;
}

static void set_camera(const Program *program, const Scene *scene, int width, int height) {
    double forward[3], right[3], up[3] = {0, 1, 0};
    double size[3] = {width, height, 0};
    double half_height = tan(scene->fov_deg * degree / 2);
    for (int i = 0; i < 3; i++) forward[i] = scene->target[i] - scene->eye[i];
    scale_to(forward, 1);
    if (fabs(forward[1]) > 1 - 1e-12) { /* straight up or down: the picture's top is +z */
        up[1] = 0;
        up[2] = 1;
    }
    cross(forward, up, right);
    scale_to(right, half_height * width / height);
    cross(right, forward, up);
    scale_to(up, half_height);
    program_set_vec3(program, "camera_eye", scene->eye);
    program_set_vec3(program, "camera_forward", forward);
    program_set_vec3(program, "camera_right", right);
    program_set_vec3(program, "camera_up", up);
    program_set_vec3(program, "picture_size", size);
}

static void set_parameters(const Program *program, const Scene *scene) {
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

/* The table that --light control looks up. */
static bool use_irradiance(Renderer *renderer, const Context *context, const RenderParams *params,
                           const Methods *methods, const SkyState *state, Error *error) {
    if (!uses_control(methods)) return true;
    return irradiance_create(&renderer->irradiance, context, params->library, &methods->sky,
                             &state->atmosphere, error) &&
           irradiance_use(&renderer->irradiance, &renderer->sky, &renderer->program, state, error);
}

bool renderer_create(Renderer *renderer, const Context *context, const RenderParams *params, Error *error) {
    const Scene *scene = params->scene;
    int width = picture_width(params), height = picture_height(params);
    SkyState state = {scene->atmosphere, scene->sun_elevation_deg, scene->sun_azimuth_deg};
    Methods methods;
    *renderer = (Renderer){.gl = &context->gl,
                           .seed = params->seed,
                           .max_hits = params->max_hits ? params->max_hits : UNLIMITED_HITS};
    if (!scene_check_size(width, height, error) || !scene_check(scene, error) ||
        !choose_methods(&methods, params, width, height, error) ||
        !choose_group(renderer, &methods, scene, width, error) ||
        !create_program(renderer, &methods, params, error) ||
        !film_create(&renderer->film, context, width, height, error) ||
        !sky_create(&renderer->sky, context, params->library, &methods.sky, &scene->atmosphere, error) ||
        !use_irradiance(renderer, context, params, &methods, &state, error) ||
        !sky_use(&renderer->sky, &renderer->program, &state, error)) {
        goto fail;
    }
    renderer->light = methods.light;
    renderer->sequence = methods.sequence;
    set_camera(&renderer->program, scene, width, height);
    set_parameters(&renderer->program, scene);
    program_set_uint(&renderer->program, "seed", renderer->seed);
    program_set_int(&renderer->program, "max_hits", renderer->max_hits);
    if (!gl_check(renderer->gl, "setting up the pass", error)) goto fail;
    return true;
fail:
    renderer_destroy(renderer);
    return false;
}

void renderer_destroy(Renderer *renderer) {
    irradiance_destroy(&renderer->irradiance);
    sky_destroy(&renderer->sky);
    film_destroy(&renderer->film);
    program_destroy(&renderer->program);
    *renderer = (Renderer){0};
}

/* Rows for the next draw, about a tenth of a second's worth. */
static int strip_rows(const Renderer *renderer, int rows_left) {
    int rows = 1;
    while (rows < rows_left && rows * 2 < renderer->rows_per_second * 0.1) rows *= 2;
    return rows < rows_left ? rows : rows_left;
}

bool renderer_pass(Renderer *renderer, uint64_t samples, bool (*stop)(void), Error *error) {
    Film *film = &renderer->film;
    unsigned group = samples < renderer->group_samples ? (unsigned)samples : renderer->group_samples;
    bool stopped = false;
    program_use(&renderer->program);
    program_set_uint(&renderer->program, "first_sample", (unsigned)film->samples);
    program_set_uint(&renderer->program, "group_samples", group);
    film_begin(film, &renderer->program);
    for (int row = 0; row < film->height && !stopped;) {
        int rows = strip_rows(renderer, film->height - row);
        double start = clock_seconds();
        program_draw(&renderer->program, film->width, row, rows);
        renderer->gl->Finish();
        renderer->rows_per_second = rows / fmax(clock_seconds() - start, 1e-6);
        row += rows;
        stopped = row < film->height && stop && stop();
    }
    if (!gl_check(renderer->gl, "drawing a pass", error)) return false;
    if (!stopped || film->samples == 0) film_commit(film, group);
    return true;
}
