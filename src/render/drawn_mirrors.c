#include "render/drawn_mirrors.h"

static bool wanted(const void *data) {
    const Frame *frame = data;
    return frame->scene && frame->sun_disk && frame->sun_disk->method->draws_image &&
           frame->scene->file->hints[HINT_MIRROR_SPHERE].in_glsl &&
           scene_hint_count(frame->scene, HINT_MIRROR_SPHERE) > 0;
}

static void size(const void *frame, int *width, int *height) {
    (void)frame;
    *width = MOST_HINTS;
    *height = 1;
}

/* Appends the scene's parameters, its time and its mouse. */
static void key(const void *frame, Text *bytes) {
    const SceneValues *values = &((const Frame *)frame)->scene->values;
    text_append(bytes, values->parameters, sizeof values->parameters);
    text_append(bytes, &values->time_s, sizeof values->time_s);
    text_append(bytes, values->mouse, sizeof values->mouse);
}

const ResourceKind drawn_mirrors = {.name = "the scene's mirror spheres",
                                    .entry = "pass/fill_mirrors.glsl",
                                    .samplers = {"drawn_mirrors"},
                                    .filter = GL_NEAREST,
                                    .wanted = wanted,
                                    .size = size,
                                    .key = key};

bool drawn_mirrors_ask(const Resources *tables, Frame *frame, Uniforms *uniforms,
                       double spheres[MOST_HINTS][4], Error *error) {
    float numbers[MOST_HINTS][4];
    Resources alone = *tables;
    const Resource *drawn = resources_find(tables, &drawn_mirrors);
    frame->mirrors = NULL;
    if (!drawn) return true;
    alone.count = 1;
    if (!resources_prepare(&alone, frame, uniforms, error) || !resource_read(drawn, 0, numbers[0], error))
        return false;
    for (int i = 0; i < 4 * MOST_HINTS; i++) spheres[i / 4][i % 4] = (double)numbers[i / 4][i % 4];
    frame->mirrors = (const double(*)[4])spheres;
    return true;
}
