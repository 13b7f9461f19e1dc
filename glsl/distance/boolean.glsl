#include "math/dialect.glsl"

// Solids made of two, by their distances (Ricci 1973; Hart 1996). The union's distance is exact outside; the others are never
// more than the distance, but may be less near edges.
float op_union(float a, float b) {
    return min(a, b);
}

float op_intersection(float a, float b) {
    return max(a, b);
}

// a without b.
float op_subtraction(float a, float b) {
    return max(a, -b);
}

// Inside out.
float op_inverse(float a) {
    return -a;
}
