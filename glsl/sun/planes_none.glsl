// For a scene that names no flat mirrors.
#include "scene.glsl"

const int PLANE_CHAIN = 0;

vec3 planes_reflect(Hit hit, Material material, vec3 incoming, vec3 toward, int mirrors, INOUT(Sequence) sequence) {
    return vec3(0.0);
}

bool planes_know(Hit hit, Material material) {
    return false;
}
