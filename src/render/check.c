#include "render/check.h"

#include "base/memory.h"
#include "gl/strips.h"

#include <math.h>
#include <stdlib.h>

/* The coarse picture's longer side at most, its paths for each pixel, and the hits of a path at most. */
enum { SIDE = 48, PATHS = 4, HITS = 8 };

/* A thousandth is more than roundings and less than what can be seen. */
static const double tolerance = 1e-3;

/* What check.glsl writes for each pixel. */
static const unsigned outputs = 3;

static void draw(const Program *program, Target *target) {
    static const char *const unread[TARGET_TEXTURES] = {NULL};
    double pixels_per_second = 1e4;
    Rectangle all = {0, 0, target->width, target->height};
    program_set_uint(program, "check_paths", PATHS);
    program_set_int(program, "check_hits", HITS);
    target_begin(target, program, unread);
    strips_draw(program, &all, 1, &pixels_per_second, NULL);
    target_swap(target);
}

static Camera coarse(const RenderParams *params, const Camera *camera) {
    int longer = camera->width > camera->height ? camera->width : camera->height;
    int width = camera->width, height = camera->height;
    if (longer > SIDE) {
        width = (width * SIDE + longer - 1) / longer;
        height = (height * SIDE + longer - 1) / longer;
    }
    return camera_of(params->scene, width, height);
}

static double farther(double squared) {
    return fmax(squared, 1 / squared);
}

static void collect(Check *check, const float *values, const float *objects, size_t pixels) {
    double squared = 1;
    *check = (Check){.done = true, .normal_length = 1, .least_albedo = 0, .largest_albedo = 1};
    for (size_t i = 0; i < pixels; i++) {
        const float *value = values + 4 * i, *object = objects + 4 * i;
        if (farther((double)value[0]) > farther(squared)) {
            squared = (double)value[0];
            check->normal_object = (int)object[0];
        }
        if ((double)value[1] < check->least_albedo) {
            check->least_albedo = (double)value[1];
            check->least_object = (int)object[1];
        }
        if ((double)value[2] > check->largest_albedo) {
            check->largest_albedo = (double)value[2];
            check->largest_object = (int)object[2];
        }
        if ((double)value[3] > check->size_over_distance) {
            check->size_over_distance = (double)value[3];
            check->far_object = (int)object[3];
        }
    }
    check->normal_length = sqrt(squared);
}

static bool read(Check *check, const Target *target, Error *error) {
    size_t pixels = (size_t)target->width * (size_t)target->height;
    float *values = memory_get(pixels, 4 * sizeof *values),
          *objects = memory_get(pixels, 4 * sizeof *objects);
    bool ok = target_read(target, 0, values, error) && target_read(target, 1, objects, error);
    if (ok) collect(check, values, objects, pixels);
    free(values);
    free(objects);
    return ok;
}

static bool compile(Program *program, const Context *context, const RenderParams *params,
                    const Renderer *renderer, Error *error) {
    GlslSource source = {0};
    bool ok = pass_text(&check_pass, &renderer->plan, params, &source, error) &&
              pass_compile(program, &context->gl, &source, params, error);
    glsl_source_destroy(&source);
    return ok;
}

bool check_scene(Check *check, const Context *context, const RenderParams *params, const Renderer *renderer,
                 Error *error) {
    Camera camera = coarse(params, &renderer->camera);
    Frame frame = frame_of(&renderer->plan, params->scene, &camera);
    Program program = {0};
    Target target = {0};
    Uniforms uniforms = {0};
    bool ok = compile(&program, context, params, renderer, error) &&
              target_create(&target, context, camera.width, camera.height, outputs, error);
    if (ok) {
        frame_uniforms(&frame, &renderer->plan, renderer->seed, &uniforms);
        resources_uniforms(&renderer->tables, &frame, &uniforms);
        program_use(&program);
        program_set(&program, &uniforms);
        resources_give(&renderer->tables, &program);
        draw(&program, &target);
        ok = gl_check(&context->gl, "checking the scene's values", error) && read(check, &target, error);
    }
    uniforms_free(&uniforms);
    target_destroy(&target);
    program_destroy(&program);
    return ok;
}

bool check_finds_normal(const Check *check) {
    return check->done && fabs(check->normal_length - 1) > tolerance;
}

bool check_finds_albedo(const Check *check) {
    return check->done && (check->least_albedo < -tolerance || check->largest_albedo > 1 + tolerance);
}

double check_far_error(const Check *check) {
    return check->done ? 4e-5 * check->size_over_distance : 0;
}
