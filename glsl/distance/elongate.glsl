#include "math/dialect.glsl"

// Cuts a solid about the origin through its middle and pulls the parts apart, by half_gap to each side along each axis. It is used as
// distance_torus(op_elongate(p, half_gap), vec3(0.0), ...). The distance is exact outside of convex solids that are their own mirror images.
// Inside, it may be less than the distance. After Quilez, "Distance functions".
vec3 op_elongate(vec3 p, vec3 half_gap) {
    return p - clamp(p, -half_gap, half_gap);
}
