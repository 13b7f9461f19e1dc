// What the passes of --sequence metropolis share: the chains' state, one chain in each texel. See src/render/chain_pass.h.
#include "sequence/chain_step.glsl"

// The light of the path at which the chain is (rgb), and in alpha the sum of the brightness of its candidates, or, once it walks, its weight.
uniform sampler2D chain_lights;
// The path's key of the numbers that the chain does not remember (xy), and whether the last step was taken (z).
uniform sampler2D chain_tails;
// The numbers that it remembers, two pairs in each texel: CHAIN_PAIRS / 2 rows of this texture for each row of chains.
uniform sampler2D chain_numbers;
uniform uint seed;
// The number of the step, of the steps since all chains began anew, and of the first ones of these, which draw candidates for the start.
uniform uint chain_number;
uniform uint chain_age;
uniform uint chain_candidates;

// The chain from which each chain takes its start, and the mean brightness that all chains then weigh (src/render/chain_pass.c).
uniform sampler2D chain_sources;
uniform float chain_mean;

bool chain_starts() {
    return chain_age < chain_candidates;
}

// The chain whose path this chain has before the step.
ivec2 chain_source(ivec2 chain) {
    vec4 source = texelFetch(chain_sources, chain, 0);
    return chain_age == chain_candidates ? ivec2(int(source.x), int(source.y)) : chain;
}

ChainStep chain_step_at(ivec2 chain) {
    return chain_step(uint(chain.x) + (uint(chain.y) << 16u), chain_number, seed, chain_starts());
}
