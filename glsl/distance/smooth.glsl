#include "math/dialect.glsl"

// Solids that flow into each other where their surfaces are within k metres: the quadratic polynomial of Quilez, "Smooth
// minimum". It adds at most k / 4, and changes by no more than a metre a metre, so that it stays below the distance.
float op_smooth_union(float a, float b, float k) {
    float share = max(k - abs(a - b), 0.0) / max(k, 1.0e-20);
    return min(a, b) - 0.25 * k * share * share;
}

float op_smooth_intersection(float a, float b, float k) {
    return -op_smooth_union(-a, -b, k);
}

// a without b.
float op_smooth_subtraction(float a, float b, float k) {
    return -op_smooth_union(-a, b, k);
}
