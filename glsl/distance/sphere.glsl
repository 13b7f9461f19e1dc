#include "math/dialect.glsl"

// Distance to a sphere, negative inside, as all of these. Each distance_NAME(p, ...) takes what hit_NAME(ray, ...) takes.
float distance_sphere(vec3 p, vec3 centre, float radius) {
    return length(p - centre) - radius;
}
