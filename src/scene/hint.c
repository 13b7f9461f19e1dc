#include "scene/hint.h"

static const HintInfo kinds[HINT_KINDS] = {
    [HINT_BOUND] = {"bound", "x y z radius, numbers or sliders", 4, "SCENE_BOUNDS", "scene_bound"},
    [HINT_MIRROR_SPHERE] = {"mirror-sphere", "x y z radius, numbers or sliders", 4, "MIRROR_SPHERES",
                            "mirror_sphere"},
    [HINT_MIRROR_PLANE] = {"mirror-plane", "the azimuth and the elevation that it faces, numbers or sliders",
                           2, "MIRROR_PLANES", "mirror_plane"},
    [HINT_EMITTER_SPHERE] = {"emitter-sphere", "x y z radius, numbers or sliders", 4, "EMITTER_SPHERES",
                             "emitter_sphere"},
};

const HintInfo *hint_info(HintKind kind) {
    return &kinds[kind];
}
