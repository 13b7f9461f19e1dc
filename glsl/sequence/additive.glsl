// --sequence additive: an additive recurrence. Dimension d of sample n is the fractional part of n / phi^(d+1) plus a shift that is
// the pixel's own, phi the root of x^25 = x + 1 (Roberts' R_24, the generalised golden ratio of 24 dimensions). In whole numbers
// modulo 2^32, so that it stays exact for any n; later dimensions start over with the sample's index scrambled.
#include "math/hash.glsl"

const float ADDITIVE_LOG2 = 0.04082222; // log2 of phi = 1.0287000
const uint ADDITIVE_PAIRS = 12u;       // pairs in 24 dimensions

struct Sequence {
    uint index;
    uint pixel;
    uint seed;
    uint dimension; // of pairs
};

Sequence sequence_start(uint x, uint y, uint sample_index, uint seed) {
    return Sequence(sample_index, x + (y << 16u), seed, 0u);
}

// The step 2^32 / phi^(d+1), odd so that it visits all of them.
uint additive_step(float d) {
    return uint(exp2(31.0 - ADDITIVE_LOG2 * (d + 1.0))) * 2u + 1u;
}

// The next two numbers in [0,1).
vec2 sequence_pair(INOUT(Sequence) sequence) {
    uvec3 shift = hash_3(uvec3(sequence.pixel, sequence.dimension, sequence.seed));
    uint turn = sequence.dimension / ADDITIVE_PAIRS;
    float first = 2.0 * float(sequence.dimension - turn * ADDITIVE_PAIRS);
    uint index = turn == 0u ? sequence.index : hash_3(uvec3(sequence.index, turn, sequence.pixel)).x;
    sequence.dimension += 1u;
    return vec2(unit_float(index * additive_step(first) + shift.x), unit_float(index * additive_step(first + 1.0) + shift.y));
}
