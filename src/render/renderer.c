#include "render/renderer.h"

#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

enum {
    MOST_GROUP_SAMPLES = 16,
    /* llvmpipe ends all loops of a shader after this many iterations together, without an error. */
    LOOP_LIMIT = 65535,
    /* "Unlimited" for the loop's sake: Russian roulette lets a path come so far with a probability below
       1e-22. */
    UNLIMITED_HITS = 1000
};

static const double degree = 3.14159265358979323846 / 180;

/* Loop iterations of one sample: itself, the path, and the sky. */
static long sample_iterations(const Renderer *renderer) {
    return 1 + (renderer->max_hits + 1L) + renderer->sky.iterations;
}

static bool choose_group(Renderer *renderer, Error *error) {
    long iterations = sample_iterations(renderer);
    if (iterations > LOOP_LIMIT) {
        return error_set(error, STATUS_USAGE,
                         "--sky %s with %d surface hits needs %ld loop iterations a sample; the limit is %d",
                         renderer->sky.text, renderer->max_hits, iterations, LOOP_LIMIT);
    }
    renderer->group_samples = MOST_GROUP_SAMPLES;
    while (renderer->group_samples * iterations > LOOP_LIMIT) renderer->group_samples /= 2;
    return true;
}

static bool choose_methods(Renderer *renderer, const RenderParams *params, Error *error) {
    const char *sky = params->sky ? params->sky : params->scene->sky[0] ? params->scene->sky : NULL;
    return method_choose(&renderer->sky, METHOD_SKY, sky, error) &&
           method_choose(&renderer->light, METHOD_LIGHT, params->light, error) &&
           method_choose(&renderer->sequence, METHOD_SEQUENCE, params->sequence, error);
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

static bool flatten(const Renderer *renderer, const RenderParams *params, GlslSource *source, Error *error) {
    const GlslSlot slots[] = {{"sequence", renderer->sequence.method->file},
                              {"sky", renderer->sky.method->file},
                              {"light", renderer->light.method->file},
                              {"scene", params->scene->path},
                              {NULL, NULL}};
    return check_scene_functions(params, error) &&
           glsl_source_create(source, params->library, "pass/trace.glsl", slots, error);
}

bool renderer_flatten(const RenderParams *params, GlslSource *source, Error *error) {
    Renderer renderer = {0};
    return choose_methods(&renderer, params, error) && flatten(&renderer, params, source, error);
}

static bool create_program(Renderer *renderer, const RenderParams *params, Error *error) {
    GlslSource source;
    if (!flatten(renderer, params, &source, error)) return false;
    bool ok = program_create(&renderer->program, renderer->gl, &source, error);
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

static void set_atmosphere(const Program *program, const Scene *scene) {
    const Atmosphere *a = &scene->atmosphere;
    double elevation = scene->sun_elevation_deg * degree, azimuth = scene->sun_azimuth_deg * degree;
    double sun[3] = {cos(elevation) * sin(azimuth), sin(elevation), cos(elevation) * cos(azimuth)};
    double rayleigh[3], mie[3], extinction[3];
    for (int c = 0; c < 3; c++) {
        rayleigh[c] = a->rayleigh * a->rayleigh_scatter_per_m[c];
        mie[c] = a->mie * a->mie_scatter_per_m[c];
        extinction[c] = mie[c] * a->mie_extinction_ratio;
    }
    program_set_vec3(program, "sun_direction", sun);
    program_set_float(program, "observer_height_m", a->observer_height_m);
    program_set_float(program, "atmosphere.planet_radius_m", a->planet_radius_m);
    program_set_float(program, "atmosphere.thickness_m", a->top_radius_m - a->planet_radius_m);
    program_set_float(program, "atmosphere.rayleigh_scale_height_m", a->rayleigh_scale_height_m);
    program_set_float(program, "atmosphere.mie_scale_height_m", a->mie_scale_height_m);
    program_set_vec3(program, "atmosphere.rayleigh_scatter_per_m", rayleigh);
    program_set_vec3(program, "atmosphere.mie_scatter_per_m", mie);
    program_set_vec3(program, "atmosphere.mie_extinction_per_m", extinction);
    program_set_float(program, "atmosphere.mie_g", a->mie_g);
    program_set_vec3(program, "atmosphere.sun_irradiance", a->sun_irradiance);
}

static void set_sky(const Program *program, const MethodChoice *sky) {
    program_set_int(program, "sky_view_samples", sky->counts[0]);
    program_set_int(program, "sky_light_samples", sky->counts[1]);
    program_set_float(program, "sky_level", sky->level);
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

bool renderer_create(Renderer *renderer, const Context *context, const RenderParams *params, Error *error) {
    const Scene *scene = params->scene;
    int width = params->width ? params->width : scene->width;
    int height = params->height ? params->height : scene->height;
    *renderer = (Renderer){.gl = &context->gl,
                           .seed = params->seed,
                           .max_hits = params->max_hits ? params->max_hits : UNLIMITED_HITS};
    if (!scene_check_size(width, height, error) || !scene_check(scene, error) ||
        !choose_methods(renderer, params, error) || !choose_group(renderer, error) ||
        !create_program(renderer, params, error) ||
        !film_create(&renderer->film, context, width, height, error)) {
        goto fail;
    }
    renderer->rows_per_second = 1e6 / width; /* a guess on the low side, for the first draw */
    program_use(&renderer->program);
    set_camera(&renderer->program, scene, width, height);
    set_atmosphere(&renderer->program, scene);
    set_sky(&renderer->program, &renderer->sky);
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
    film_destroy(&renderer->film);
    program_destroy(&renderer->program);
    *renderer = (Renderer){0};
}

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
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
        double start = now();
        program_draw(&renderer->program, film->width, row, rows);
        renderer->gl->Finish();
        renderer->rows_per_second = rows / fmax(now() - start, 1e-6);
        row += rows;
        stopped = row < film->height && stop && stop();
    }
    if (!gl_check(renderer->gl, "drawing a pass", error)) return false;
    if (!stopped || film->samples == 0) film_commit(film, group);
    return true;
}
