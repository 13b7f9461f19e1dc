#include "distance/box.glsl"

// Distance to a box along the axes, `half_size` from its centre to its faces, with edges rounded by `radius`.
float distance_rounded_box(vec3 p, vec3 centre, vec3 half_size, float radius) {
    return distance_box(p, centre, half_size - radius) - radius;
}
