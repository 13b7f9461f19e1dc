// --sequence additive: an additive recurrence.
// Dimension d of sample n is the fractional part of n / phi^(d+1) + shift. Each pixel has shifts of its own. phi is the root of
// x^25 = x + 1: the generalised golden ratio of 24 dimensions (Roberts' R_24).
// The arithmetic is in whole numbers modulo 2^32, so it is exact for any n. Dimensions beyond 24 start over with a scrambled index.
#include "math/hash.glsl"

// The base-2 logarithm of phi = 1.0287000.
const float ADDITIVE_LOG2 = 0.04082222;
// The number of pairs in 24 dimensions.
const uint ADDITIVE_PAIRS = 12u;

struct Sequence {
    uint index;
    uint pixel;
    uint seed;
    // Counts pairs of dimensions.
    uint dimension;
};

Sequence sequence_start(uint x, uint y, uint sample_index, uint seed) {
    return Sequence(sample_index, x + (y << 16u), seed, 0u);
}

// Returns the step 2^32 / phi^(d+1), rounded to an odd number so that the recurrence visits all 2^32 numbers.
uint additive_step(float d) {
    return uint(exp2(31.0 - ADDITIVE_LOG2 * (d + 1.0))) * 2u + 1u;
}

// Returns the next two random numbers, in [0,1).
vec2 sequence_pair(INOUT(Sequence) sequence) {
    uvec3 shift = hash_3(uvec3(sequence.pixel, sequence.dimension, sequence.seed));
    uint turn = sequence.dimension / ADDITIVE_PAIRS;
    float first = 2.0 * float(sequence.dimension - turn * ADDITIVE_PAIRS);
    uint index = turn == 0u ? sequence.index : hash_3(uvec3(sequence.index, turn, sequence.pixel)).x;
    sequence.dimension += 1u;
    return vec2(unit_float(index * additive_step(first) + shift.x), unit_float(index * additive_step(first + 1.0) + shift.y));
}
