#include "math/dialect.glsl"

// Distance to a flat disk about `centre`. `normal` has unit length.
// A disk has no inside, so its distance is nowhere negative. Give it a thickness by op_round(); otherwise march() sees it only because it
// stops within its precision of a surface.
float distance_disk(vec3 p, vec3 centre, vec3 normal, float radius) {
    float height = dot(p - centre, normal);
    float across = length(p - centre - height * normal);
    return length(vec2(max(across - radius, 0.0), height));
}
