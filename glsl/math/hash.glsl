#include "math/dialect.glsl"

// The hash PCG in three dimensions, from Jarzynski and Olano 2020, "Hash Functions for GPU Rendering".
// Their two-dimensional hash is not good enough here: it correlates neighbouring dimensions (chi-square is 14 standard deviations off).
uvec3 hash_3(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v = v ^ (v >> 16u);
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

// Turns the upper 24 bits into a float in [0,1).
float unit_float(uint bits) {
    return float(bits >> 8u) * (1.0 / 16777216.0);
}
