#include "math/dialect.glsl"

// Distance to a link of a chain: a ring about `axis` that is cut in the middle, with its halves pulled apart by half_length to each side along
// `along`. Both have unit length and are at right angles. The radii are those of distance_torus(). The distance is exact.
float distance_link(vec3 p, vec3 centre, vec3 axis, vec3 along, float half_length, float major, float minor) {
    vec3 from_centre = p - centre;
    float x = dot(from_centre, along);
    vec2 q = vec2(max(abs(x) - half_length, 0.0), dot(from_centre, cross(axis, along)));
    return length(vec2(length(q) - major, dot(from_centre, axis))) - minor;
}
