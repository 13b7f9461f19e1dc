#include "math/dialect.glsl"

// Returns the direction in which a mirror sends on light that comes along the unit vector `incoming`. It has unit length too.
// reflect() keeps the length only up to roundings, and they add up from mirror to mirror. A ray within a mirror sphere missed the sphere after some
// twenty reflections, because shapes rely on the length.
vec3 mirror_direction(vec3 incoming, vec3 normal) {
    return normalize(reflect(incoming, normal));
}
