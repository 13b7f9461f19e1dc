#include "math/dialect.glsl"

// Adds a solid's mirror image behind the plane dot(normal, p) = offset. `normal` has unit length and points to the solid, which must stay on that
// side. The distance is as exact as that of the solid.
vec3 op_mirror(vec3 p, vec3 normal, float offset) {
    return p - 2.0 * min(dot(normal, p) - offset, 0.0) * normal;
}
