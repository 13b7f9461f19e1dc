#include "math/dialect.glsl"

// How much the second of two solids counts where both are joined, from 0 to 1, for the colour or the material there:
//
//     mix(color_a, color_b, share_smooth_union(a, b, k))
//
// It is the derivative of the joined distance by b: the share that b has in the normal, too. So colours change just where the shape does. It is
// continuous, and the shares of a and b sum to 1.
float share_union(float a, float b) {
    return step(b, a);
}

// For op_smooth_union() (distance/smooth.glsl).
float share_smooth_union(float a, float b, float k) {
    return clamp(0.5 + 0.5 * (a - b) / max(k, 1.0e-20), 0.0, 1.0);
}

// For op_smooth_union_circular() and op_smooth_union_root() (distance/smooth_kinds.glsl).
float share_smooth_union_circular(float a, float b, float k) {
    float gap = min(abs(a - b) / max(k, 1.0e-20), 1.0);
    float far = 0.5 * (1.0 - gap / sqrt(2.0 - gap * gap));
    float near = 1.0 - far;
    return a < b ? far : near;
}

float share_smooth_union_root(float a, float b, float k) {
    return 0.5 + 0.5 * (a - b) / max(length(vec2(a - b, k)), 1.0e-20);
}
