#include "sky/scattered.h"

#include <math.h>

enum { TABLE_COLUMNS = 32, TABLE_ROWS = 64 };

bool sky_is_scattered(const MethodChoice *sky, const Scene *scene) {
    return (sky->table || !sky->method->integrates) && scene_has_mist(scene);
}

static bool wants_scattered(const void *data) {
    const Frame *frame = data;
    return frame->scene && frame->light && sky_is_scattered(frame->sky, frame->scene);
}

static void scattered_size(const void *frame, int *width, int *height) {
    (void)frame;
    *width = TABLE_COLUMNS;
    *height = TABLE_ROWS;
}

static void scattered_key(const void *frame, Text *key) {
    double forward = scene_mist_forward(((const Frame *)frame)->scene);
    text_append(key, &forward, sizeof forward);
}

/* The table's texels are three to six degrees wide, and the light that turns by a narrow peak has finer
 * detail. From a mean cosine of 0.75 on it is not used. */
static double share_of(double forward) {
    return fmin(fmax((0.75 - fabs(forward)) / 0.1, 0), 1);
}

static void scattered_uniforms(const Resource *scattered, const void *frame, Uniforms *uniforms) {
    static const double size[3] = {TABLE_COLUMNS, TABLE_ROWS, 0};
    (void)scattered;
    uniforms_declared_in(uniforms, "pass/fill_scattered.glsl");
    uniforms_vec3(uniforms, "scattered_size", size);
    uniforms_float(uniforms, "scattered_forward", scene_mist_forward(((const Frame *)frame)->scene));
    uniforms_int(uniforms, "patch_columns", PATCH_COLUMNS);
    uniforms_int(uniforms, "patch_rows", PATCH_ROWS);
    uniforms_declared_in(uniforms, "pass/mist_sky.glsl");
    uniforms_float(uniforms, "scattered_share", share_of(scene_mist_forward(((const Frame *)frame)->scene)));
    uniforms_vec3(uniforms, "scattered_size", size);
}

const ResourceKind sky_scattered = {.name = "the sky's light in mist",
                                    .entry = "pass/fill_scattered.glsl",
                                    .samplers = {"scattered_table"},
                                    .filter = GL_LINEAR,
                                    .inputs = {&sky_patches},
                                    .wanted = wants_scattered,
                                    .size = scattered_size,
                                    .key = scattered_key,
                                    .uniforms = scattered_uniforms};
