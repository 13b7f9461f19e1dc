#include "math/dialect.glsl"

// The colour is `low` at the point `from` and `high` at the point `to`. It is linear between the two points, and constant beyond them.
vec3 gradient(vec3 position, vec3 from, vec3 to, vec3 low, vec3 high) {
    vec3 along = to - from;
    return mix(low, high, clamp(dot(position - from, along) / dot(along, along), 0.0, 1.0));
}
