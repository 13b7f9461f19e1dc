#include "math/dialect.glsl"

// Solids made of two solids, by combining their distances (Ricci 1973; Hart 1996).
// The distance to the union is exact outside of it. The other results are never more than the distance, but may be less near edges.
float op_union(float a, float b) {
    return min(a, b);
}

float op_intersection(float a, float b) {
    return max(a, b);
}

// The solid a without the solid b.
float op_subtraction(float a, float b) {
    return max(a, -b);
}

// Turns a solid inside out.
float op_inverse(float a) {
    return -a;
}

// What is in one of the two solids, but not in both. It is exact where both distances are.
float op_xor(float a, float b) {
    return max(min(a, b), -max(a, b));
}
