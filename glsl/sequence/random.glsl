// --sequence random: independent numbers. A hash of (pixel, sample, seed) gives a key, and a hash of the key and the dimension gives the numbers.
#include "math/hash.glsl"

struct Sequence {
    // Belongs to one sample of one pixel.
    uvec2 key;
    uint dimension;
};

Sequence sequence_start(uint x, uint y, uint sample_index, uint seed) {
    uvec3 hash = hash_3(uvec3(x + (y << 16u), sample_index, seed));
    return Sequence(uvec2(hash.x, hash.y), 0u);
}

// Returns the next two random numbers, in [0,1).
vec2 sequence_pair(INOUT(Sequence) sequence) {
    uvec3 hash = hash_3(uvec3(sequence.key.x, sequence.key.y, sequence.dimension));
    sequence.dimension += 1u;
    return vec2(unit_float(hash.x), unit_float(hash.y));
}
