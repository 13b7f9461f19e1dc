#include "math/dialect.glsl"

// Cuts a solid about the origin through its middle and pulls the halves apart, by half_gap to each side along each axis:
// distance_torus(op_elongate(p, half_gap), vec3(0.0), ...). Exact outside of convex solids that are their own mirror images;
// inside, the distance may be less. After Quilez, "Distance functions".
vec3 op_elongate(vec3 p, vec3 half_gap) {
    return p - clamp(p, -half_gap, half_gap);
}
