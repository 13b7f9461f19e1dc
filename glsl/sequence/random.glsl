// --sequence random: every number independent, by hashing (pixel, sample, seed) and then the dimension.
#include "math/dialect.glsl"

struct Sequence {
    uvec2 key; // of this pixel's sample
    uint dimension;
};

// PCG in three dimensions: Jarzynski and Olano 2020, "Hash Functions for GPU Rendering". (Their two-dimensional hash is
// not enough here: pairs of neighbouring dimensions come out correlated, chi-square 14 deviations off.)
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

Sequence sequence_start(uint x, uint y, uint sample_index, uint seed) {
    uvec3 hash = hash_3(uvec3(x + (y << 16u), sample_index, seed));
    return Sequence(uvec2(hash.x, hash.y), 0u);
}

// The next two numbers in [0,1).
vec2 sequence_pair(INOUT(Sequence) sequence) {
    uvec3 hash = hash_3(uvec3(sequence.key.x, sequence.key.y, sequence.dimension));
    sequence.dimension += 1u;
    return vec2(uvec2(hash.x, hash.y) >> 8u) * (1.0 / 16777216.0);
}
