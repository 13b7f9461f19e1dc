#include "scene/hint.h"

#include "base/number.h"

#include <string.h>

static const HintInfo kinds[HINT_KINDS] = {
    [HINT_BOUND] = {.key = "bound",
                    .needs = "x y z radius, numbers or sliders",
                    .components = 4,
                    .lengths_from = 3,
                    .constant = "SCENE_BOUNDS",
                    .function = "scene_bound",
                    .type = "vec4",
                    .maker = "vec4",
                    .loops_each = 2},
    [HINT_MIRROR_SPHERE] = {.key = "mirror-sphere",
                            .needs = "x y z radius, numbers or sliders",
                            .components = 4,
                            .lengths_from = 3,
                            .constant = "MIRROR_SPHERES",
                            .function = "mirror_sphere",
                            .type = "vec4",
                            .maker = "vec4",
                            .rays = 2,
                            .loops = 6,
                            .loops_each = 5},
    /* A chain has up to 4 mirrors (PLANE_CHAIN in glsl/sun/planes.glsl). Each of its rays asks which mirror
     * it met, and which it should. */
    [HINT_MIRROR_PLANE] = {.key = "mirror-plane",
                           .needs = "the azimuth and the elevation that it faces, numbers or sliders",
                           .components = 2,
                           .lengths_from = 2,
                           .constant = "MIRROR_PLANES",
                           .function = "mirror_plane",
                           .type = "vec2",
                           .maker = "vec2",
                           .rays = 5,
                           .loops = 44,
                           .loops_each = 4},
    [HINT_EMITTER_SPHERE] = {.key = "emitter-sphere",
                             .needs = "x y z radius, numbers or sliders",
                             .components = 4,
                             .lengths_from = 3,
                             .constant = "EMITTER_SPHERES",
                             .function = "emitter_sphere",
                             .type = "vec4",
                             .maker = "vec4",
                             .rays = 1,
                             .loops_each = 3},
    [HINT_PORTAL] = {.key = "portal",
                     .needs = "x y z, the azimuth and the elevation that it faces, width and height, numbers "
                              "or sliders",
                     .components = 7,
                     .lengths_from = 5,
                     .constant = "SCENE_PORTALS",
                     .function = "scene_portal",
                     .type = "mat3",
                     .maker = "rectangle_facing",
                     .rays = 1,
                     .loops_each = 3},
};

const HintInfo *hint_info(HintKind kind) {
    return &kinds[kind];
}

static bool same_word(const char *a, const char *b) {
    double x, y;
    if (number_parse(a, &x) && number_parse(b, &y)) return !(x < y) && !(x > y);
    return strcmp(a, b) == 0;
}

bool hint_same(HintKind kind, const Hint *a, const Hint *b) {
    for (int i = 0; i < kinds[kind].components; i++) {
        if (!same_word(a->words[i], b->words[i])) return false;
    }
    return true;
}

void hint_write(HintKind kind, const HintList *hints, Text *text) {
    const HintInfo *info = &kinds[kind];
    text_print(text, "const int %s = %d;\n%s %s(int i) {\n", info->constant, hints->count, info->type,
               info->function);
    for (int i = 0; i < hints->count; i++) {
        text_print(text, "    if (i == %d) return %s(", i, info->maker);
        for (int k = 0; k < info->components; k++)
            text_print(text, "%sfloat(%s)", k ? ", " : "", hints->list[i].words[k]);
        text_print(text, ");\n");
    }
    text_print(text, "    return %s(0.0);\n}", info->type);
}
