#include "math/dialect.glsl"

// Distance to the half-space where dot(normal, p) < offset. `normal` has unit length.
float distance_plane(vec3 p, vec3 normal, float offset) {
    return dot(normal, p) - offset;
}
