#include "math/dialect.glsl"

// Distance to a flat disk about `centre`; `normal` of unit length. It has no inside, so that a field of it alone is nowhere
// negative: give it a thickness by op_round(), or march() finds it by its precision alone.
float distance_disk(vec3 p, vec3 centre, vec3 normal, float radius) {
    float height = dot(p - centre, normal);
    float across = length(p - centre - height * normal);
    return length(vec2(max(across - radius, 0.0), height));
}
