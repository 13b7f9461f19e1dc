// The random numbers of a path that a chain proposes. A pass defines `vec2 chain_kept(uint dimension)`, the pairs of the path at which the chain is, before
// it includes this file.
#include "sequence/chain_step.glsl"

struct Sequence {
    ChainStep step;
    // The key of the numbers that the chain does not remember, 24 bits each.
    uvec2 tail;
    uint dimension;
};

// `tail` is the key of the path at which the chain is.
Sequence sequence_of_chain(ChainStep step, uvec2 tail) {
    return Sequence(step, step.large ? uvec2(step.key.x >> 8u, step.key.y >> 8u) : tail, 0u);
}

// Returns the next two random numbers, in [0,1).
vec2 sequence_pair(INOUT(Sequence) sequence) {
    uint dimension = sequence.dimension;
    uvec3 hash = hash_3(uvec3(sequence.tail.x, sequence.tail.y, dimension));
    sequence.dimension += 1u;
    if (dimension >= CHAIN_PAIRS) return vec2(unit_float(hash.x), unit_float(hash.y));
    return chain_pair(chain_kept(dimension), sequence.step, dimension);
}
