// --sequence random: every number independent, by hashing (pixel, sample, seed) and the dimension.
// Hashes: PCG in three and two dimensions, Jarzynski and Olano 2020, "Hash Functions for GPU Rendering".

struct Sequence {
    uvec2 key; // of this pixel's sample
    uint dimension;
};

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

uvec2 hash_2(uvec2 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v = v ^ (v >> 16u);
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    return v ^ (v >> 16u);
}

Sequence sequence_start(uint x, uint y, uint sample_index, uint seed) {
    uvec3 hash = hash_3(uvec3(x + (y << 16u), sample_index, seed));
    return Sequence(uvec2(hash.x, hash.y), 0u);
}

// The next two numbers in [0,1).
vec2 sequence_pair(INOUT(Sequence) sequence) {
    uvec2 hash = hash_2(uvec2(sequence.key.x + sequence.dimension, sequence.key.y));
    sequence.dimension += 1u;
    return vec2(hash >> 8u) * (1.0 / 16777216.0);
}
