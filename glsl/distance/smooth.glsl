#include "math/dialect.glsl"

// Solids that flow into each other where their surfaces are within k metres of each other. The formula is the quadratic polynomial of
// Quilez, "Smooth minimum". It adds at most k / 4 to the solid. The result changes by at most one metre a metre, so it stays below the distance.
float op_smooth_union(float a, float b, float k) {
    float share = max(k - abs(a - b), 0.0) / max(k, 1.0e-20);
    return min(a, b) - 0.25 * k * share * share;
}

float op_smooth_intersection(float a, float b, float k) {
    return -op_smooth_union(-a, -b, k);
}

// The solid a without the solid b.
float op_smooth_subtraction(float a, float b, float k) {
    return -op_smooth_union(-a, b, k);
}
