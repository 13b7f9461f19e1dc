// A step of a Markov chain over paths, in primary sample space (Kelemen et al. 2002): the chain's place is the list of random numbers that a path is made
// of. A small step moves every number a little, a large step draws all of them anew. Both are as likely as their way back, so that a new place is taken with
// the probability of Metropolis, and each path comes in proportion to its brightness.
#include "math/hash.glsl"

// The share of large steps.
const float CHAIN_LARGE = 0.3;
// The pairs of numbers that a chain remembers. Those beyond them follow from a key, which small steps keep.
const uint CHAIN_PAIRS = 16u;
// The dimension of the step's own choices. No path comes so far.
const uint CHAIN_CHOICES = 0xffffffffu;

struct ChainStep {
    // Gives the step's random numbers.
    uvec2 key;
    bool large;
    // The new place is taken if its probability is above this number, in [0,1).
    float threshold;
};

// Step number `step` of a chain. `large` makes it a large one in any case.
ChainStep chain_step(uint chain, uint step, uint seed, bool large) {
    uvec3 hash = hash_3(uvec3(chain, step, seed));
    uvec3 choices = hash_3(uvec3(hash.x, hash.y, CHAIN_CHOICES));
    return ChainStep(uvec2(hash.x, hash.y), large || unit_float(choices.x) < CHAIN_LARGE, unit_float(choices.y));
}

// Moves a number of [0,1), a whole number of 2^-24, up or down by 2^-6 to 2^-10. The logarithm of the distance is uniform, and the ends of [0,1) are joined.
// In whole numbers a move is as likely as the one back to the last bit, and every number is met equally often.
float chain_move(float number, float u, bool up) {
    uint distance = uint(exp2(18.0 - 4.0 * u));
    uint moved = uint(number * 16777216.0) + (up ? distance : 16777216u - distance);
    return float(moved & 16777215u) * (1.0 / 16777216.0);
}

// The pair of numbers that the step proposes in place of the pair that the chain has kept.
vec2 chain_pair(vec2 kept, ChainStep step, uint dimension) {
    uvec3 hash = hash_3(uvec3(step.key.x, step.key.y, dimension));
    vec2 fresh = vec2(unit_float(hash.x), unit_float(hash.y));
    vec2 moved = vec2(chain_move(kept.x, fresh.x, (hash.z & 0x80000000u) != 0u), chain_move(kept.y, fresh.y, (hash.z & 0x40000000u) != 0u));
    return step.large ? fresh : moved;
}

// The probability with which a chain goes from a path of brightness `before` to one of brightness `after`.
float chain_acceptance(float before, float after) {
    return after >= before ? 1.0 : after / before;
}

// A candidate for a chain's start, of brightness `after`, takes the place of those before it, of the sum `before`, with this probability. Of all candidates
// each is then the start in proportion to its brightness.
float chain_choice(float before, float after) {
    return after > 0.0 ? after / (before + after) : 0.0;
}

// Light may be negative in one estimate of it (light/control.glsl), and its brightness is 0 only where there is none.
float chain_brightness(vec3 light) {
    return (abs(light.x) + abs(light.y) + abs(light.z)) / 3.0;
}
