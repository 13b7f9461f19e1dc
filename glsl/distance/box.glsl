#include "math/dialect.glsl"

// Distance to a box along the axes, `half_size` from its centre to its faces. After Hart 1996 and Quilez, "Distance functions".
float distance_box(vec3 p, vec3 centre, vec3 half_size) {
    vec3 past = abs(p - centre) - half_size;
    return length(max(past, vec3(0.0))) + min(max(max(past.x, past.y), past.z), 0.0);
}
