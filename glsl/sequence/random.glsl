// --sequence random: every number independent, by hashing (pixel, sample, seed) and then the dimension.
#include "math/hash.glsl"

struct Sequence {
    uvec2 key; // of this pixel's sample
    uint dimension;
};

Sequence sequence_start(uint x, uint y, uint sample_index, uint seed) {
    uvec3 hash = hash_3(uvec3(x + (y << 16u), sample_index, seed));
    return Sequence(uvec2(hash.x, hash.y), 0u);
}

// The next two numbers in [0,1).
vec2 sequence_pair(INOUT(Sequence) sequence) {
    uvec3 hash = hash_3(uvec3(sequence.key.x, sequence.key.y, sequence.dimension));
    sequence.dimension += 1u;
    return vec2(unit_float(hash.x), unit_float(hash.y));
}
