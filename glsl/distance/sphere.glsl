#include "math/dialect.glsl"

// Distance to a sphere. It is negative inside the sphere, as all distances of this folder are inside their solids.
// Each distance_NAME(p, ...) has the parameters of hit_NAME(ray, ...).
float distance_sphere(vec3 p, vec3 centre, float radius) {
    return length(p - centre) - radius;
}
