#include "render/check.h"

#include "base/memory.h"
#include "gl/strips.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The coarse picture's longer side at most, its paths for each pixel, and the hits of a path at most. */
enum { SIDE = 48, PATHS = 4, HITS = 8 };

/* A kind of value: the value of a good surface, and how far from it a value may be. A value is the worse the
 * higher it is, the lower it is, or, for a length, the farther it is from 1 as a ratio. */
typedef enum Worse { WORSE_HIGHER, WORSE_LOWER, WORSE_AS_RATIO } Worse;

typedef struct Kind {
    Worse worse;
    double good, tolerance;
    /* What is wrong with the object, with the value, and what becomes of it. */
    const char *words;
} Kind;

/* A thousandth is more than roundings and less than what can be seen. */
static const double unseen = 1e-3;

/* The error in percent that surfaces make whose coordinates are large beside their distance: rays start a few
 * float steps above the surfaces that they leave, and the steps grow with the coordinates. A ball on a plane,
 * seen from 4 m, was off by 0.02 % at 1 km from the origin, by 0.10 % at 10 km, 0.8 % at 100 km, and 1.9 % at
 * 1000 km. This is a straight line above these figures. A tenth of the default error may pass. */
static const double percent_per_ratio = 4e-5, far_percent = 0.1;

/* In the order of the channels that check.glsl writes. */
static const Kind kinds[CHECK_KINDS] = {
    {WORSE_AS_RATIO, 1, unseen, "has a normal of length %.4g; it is given unit length"},
    {WORSE_LOWER, 0, unseen, "has an albedo of %.4g; what is below 0 is taken as 0"},
    {WORSE_HIGHER, 1, unseen, "has an albedo of %.4g; what is above 1 is taken as 1"},
    {WORSE_HIGHER, 0, far_percent,
     "is seen where its coordinates are large beside its distance from the camera. Float has too few digits "
     "there, which "
     "makes an error of up to %.1g %%. Move the scene to the origin"},
    {WORSE_LOWER, 0, unseen, "has a roughness of %.4g; what is below 0 is taken as 0"},
    {WORSE_HIGHER, 1, unseen, "has a roughness of %.4g; what is above 1 is taken as 1"},
    {WORSE_LOWER, 0.1, unseen, "has an index of refraction of %.4g; what is below 0.1 is taken as 0.1"},
    {WORSE_HIGHER, 0, unseen,
     "scene_mist() leaves the range from 0 to 1 by %.4g; what is below 0 is taken as 0, and what is above 1 "
     "as 1"},
};
enum { FAR = 3, MIST = 7 };

/* What check.glsl writes for each pixel: values, their objects, both for the other kinds, and what it counts
 * of mist's tracks. */
static const unsigned outputs = 31;
enum { TRACKS = 4 };

/* The share of the light of mist's ways that may come through too much, because tracks end early: about one
 * track of those that are followed. */
static const double track_tolerance = 1e-4;

static void draw(const Program *program, Target *target) {
    static const char *const unread[TARGET_TEXTURES] = {NULL};
    Rectangle all = {0, 0, target->width, target->height};
    program_set_uint(program, "check_paths", PATHS);
    program_set_int(program, "check_hits", HITS);
    target_begin(target, program, unread);
    Pace pace = {0};
    Strips strips = {.program = program, .picture = all, .regions = &all, .count = 1, .samples = PATHS};
    strips_draw(&strips, &pace);
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

static double badness(const Kind *kind, double value) {
    switch (kind->worse) {
    case WORSE_HIGHER:
        return value - kind->good;
    case WORSE_LOWER:
        return kind->good - value;
    case WORSE_AS_RATIO:
        return fmax(value, 1 / value) - 1;
    }
    return 0;
}

/* The values as they are printed, from those of the shader. */
static double value_of(int kind, float written) {
    double value = (double)written;
    return kind == 0 ? sqrt(value) : kind == FAR ? percent_per_ratio * value : value;
}

static void collect(Check *check, int first, const float *values, const float *objects, size_t pixels) {
    for (int kind = first; kind < first + 4 && kind < CHECK_KINDS; kind++) {
        CheckValue *worst = &check->worst[kind];
        *worst = (CheckValue){kinds[kind].good, 0};
        for (size_t i = 0; i < pixels; i++) {
            size_t at = 4 * i + (size_t)(kind - first);
            double value = value_of(kind, values[at]);
            if (badness(&kinds[kind], value) > badness(&kinds[kind], worst->value))
                *worst = (CheckValue){value, (int)objects[at]};
        }
    }
}

static void collect_tracks(Check *check, const float *counts, size_t pixels) {
    double ways = 0;
    for (size_t i = 0; i < pixels; i++) {
        ways += (double)counts[4 * i];
        check->track_light += (double)counts[4 * i + 1];
        check->tracks_cut += (double)counts[4 * i + 2];
    }
    check->track_light /= fmax(ways, 1);
    check->tracks_cut /= fmax(ways, 1);
}

static bool read(Check *check, const Target *target, Error *error) {
    size_t pixels = (size_t)target->width * (size_t)target->height;
    float *values = memory_get(pixels, 4 * sizeof *values),
          *objects = memory_get(pixels, 4 * sizeof *objects);
    bool ok = true;
    for (int half = 0; ok && half < 2; half++) {
        ok =
            target_read(target, 2 * half, values, error) && target_read(target, 2 * half + 1, objects, error);
        if (ok) collect(check, 4 * half, values, objects, pixels);
    }
    ok = ok && target_read(target, TRACKS, values, error);
    if (ok) collect_tracks(check, values, pixels);
    check->done = ok;
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
    Frame frame = frame_of(&renderer->plan, params, &camera);
    Program program = {0};
    Target target = {0};
    Uniforms uniforms = {0};
    *check = (Check){.mist_line = params->scene->file->mist.line};
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

static void print_tracks(const Check *check, const char *path, Text *out) {
    if (!check->done || check->track_light <= track_tolerance) return;
    if (path) text_print(out, "magichour: warning: %s:%d: ", path, check->mist_line);
    text_print(out,
               "tracks through mist end after 64 steps: on %.3g %% of the ways through it more light comes "
               "through than should, %.2g %% of all. Tracks are shorter with a smaller extinction, of which "
               "scene_mist() is then a larger share, or in a smaller region\n",
               100 * check->tracks_cut, 100 * check->track_light);
}

void check_print(const Check *check, const char *path, Text *out) {
    for (int i = 0; check->done && i < CHECK_KINDS; i++) {
        const CheckValue *worst = &check->worst[i];
        char words[256];
        if (badness(&kinds[i], worst->value) <= kinds[i].tolerance) continue;
        snprintf(words, sizeof words, kinds[i].words, worst->value);
        if (path) text_print(out, "magichour: warning: %s: ", path);
        if (i != MIST) text_print(out, "object %d ", worst->object);
        text_print(out, "%s\n", words);
    }
    print_tracks(check, path, out);
}
