#include "math/dialect.glsl"

// Distance to a ring about `axis`, which has unit length and goes through `centre`. The ring is a circle of the radius `major`, and all points
// within `minor` of it.
float distance_torus(vec3 p, vec3 centre, vec3 axis, float major, float minor) {
    float height = dot(p - centre, axis);
    float across = length(p - centre - height * axis);
    return length(vec2(across - major, height)) - minor;
}
