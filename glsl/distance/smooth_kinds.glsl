#include "math/dialect.glsl"

// Two more ways for solids to flow into each other (after Quilez, "Smooth minimum"); distance/smooth.glsl has the first. Where the surfaces are at right
// angles, the circular kind makes an arc of the radius k, and the root kind a hyperbola, which reaches on without an end. The results change
// by at most one metre a metre, so they stay below the distance.
float op_smooth_union_circular(float a, float b, float k) {
    float share = max(k - abs(a - b), 0.0) / max(k, 1.0e-20);
    return min(a, b) - 0.5 * k * (1.0 + share - sqrt(1.0 + share * (2.0 - share)));
}

float op_smooth_intersection_circular(float a, float b, float k) {
    return -op_smooth_union_circular(-a, -b, k);
}

// The solid a without the solid b.
float op_smooth_subtraction_circular(float a, float b, float k) {
    return -op_smooth_union_circular(-a, b, k);
}

// Adds k / 2 to the solid where both surfaces are as far, and less elsewhere.
float op_smooth_union_root(float a, float b, float k) {
    return 0.5 * (a + b - length(vec2(a - b, k)));
}

float op_smooth_intersection_root(float a, float b, float k) {
    return -op_smooth_union_root(-a, -b, k);
}

// The solid a without the solid b.
float op_smooth_subtraction_root(float a, float b, float k) {
    return -op_smooth_union_root(-a, b, k);
}
