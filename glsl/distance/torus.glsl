#include "math/dialect.glsl"

// Distance to a ring about `axis` (of unit length) through `centre`: the circle of the major radius, `minor` thick all around.
float distance_torus(vec3 p, vec3 centre, vec3 axis, float major, float minor) {
    float height = dot(p - centre, axis);
    float across = length(p - centre - height * axis);
    return length(vec2(across - major, height)) - minor;
}
