#include "../item.glsl"
#include "sequence/chain_step.glsl"

// a: chain, step, seed, dimension; b: a number, u, a second number, a brightness. c: the moved number, the proposed pair, the threshold;
// d: whether the step is large, the acceptance of one brightness after the other, the choice of a candidate, the brightness of a light.
void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    ChainStep step = chain_step(uint(a.x), uint(a.y), uint(a.z), false);
    vec2 pair = chain_pair(vec2(b.x, b.z), step, uint(a.w));
    c = vec4(chain_move(b.x, b.y, uint(a.x) % 2u == 0u), pair.x, pair.y, step.threshold);
    d = vec4(step.large ? 1.0 : 0.0, chain_acceptance(b.x, b.w), chain_choice(b.x, b.w), chain_brightness(vec3(b.x, -b.z, b.w)));
}
