// --sequence sobol: scrambled Sobol points.
// Each pair of dimensions uses the first two dimensions of Sobol's sequence. A hash shuffles the sample's index and scrambles the points as Owen
// does (Burley 2020, "Practical Hash-based Owen Scrambling"). The samples of a pixel are spread evenly in each pair.
// Different pairs, pixels and seeds are independent of each other.
#include "math/hash.glsl"

struct Sequence {
    // The sample's index with its bits reversed, so that the lowest bit comes first.
    uint reversed_index;
    uint pixel;
    uint seed;
    uint dimension;
};

uint reverse_bits(uint x) {
    x = (x << 16u) | (x >> 16u);
    x = ((x & 0x00ff00ffu) << 8u) | ((x >> 8u) & 0x00ff00ffu);
    x = ((x & 0x0f0f0f0fu) << 4u) | ((x >> 4u) & 0x0f0f0f0fu);
    x = ((x & 0x33333333u) << 2u) | ((x >> 2u) & 0x33333333u);
    return ((x & 0x55555555u) << 1u) | ((x >> 1u) & 0x55555555u);
}

// Scrambles a number as Owen does. The number's bits are reversed, so that each bit changes only by the bits below it.
// The method is that of Laine and Karras 2011, with the constants that Vegdahl found.
uint scramble_reversed(uint x, uint seed) {
    x = x ^ (x * 0x3d20adeau);
    x += seed;
    x *= (seed >> 16u) | 1u;
    x = x ^ (x * 0x05526c56u);
    return x ^ (x * 0x53a22864u);
}

// Returns the second dimension of Sobol's sequence for an index, with reversed bits. This is the product with Pascal's triangle modulo 2.
// Five steps are enough (Ahmed 2024), because the triangle consists of three copies of its half.
uint pascal(uint x) {
    x = x ^ ((x >> 1u) & 0x55555555u);
    x = x ^ ((x >> 2u) & 0x33333333u);
    x = x ^ ((x >> 4u) & 0x0f0f0f0fu);
    x = x ^ ((x >> 8u) & 0x00ff00ffu);
    return x ^ ((x >> 16u) & 0x0000ffffu);
}

Sequence sequence_start(uint x, uint y, uint sample_index, uint seed) {
    return Sequence(reverse_bits(sample_index), x + (y << 16u), seed, 0u);
}

// Returns the next two random numbers, in [0,1).
vec2 sequence_pair(INOUT(Sequence) sequence) {
    uvec3 seeds = hash_3(uvec3(sequence.pixel, sequence.dimension, sequence.seed));
    uint index = reverse_bits(scramble_reversed(sequence.reversed_index, seeds.x));
    sequence.dimension += 1u;
    uint first = reverse_bits(scramble_reversed(index, seeds.y));
    uint second = reverse_bits(scramble_reversed(pascal(index), seeds.z));
    return vec2(unit_float(first), unit_float(second));
}
