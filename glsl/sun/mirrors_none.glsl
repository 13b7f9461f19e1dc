// For a scene that names no mirror spheres.
#include "scene.glsl"

vec3 mirrors_reflect(Hit hit, Material material, vec3 incoming, vec3 toward, vec3 irradiance, INOUT(Sequence) sequence) {
    return vec3(0.0);
}

bool mirrors_know(Hit hit, Material material, vec3 incoming) {
    return false;
}
