#version 330 core
// Moves the numbers of the chains that have taken their step (pass/metropolis.glsl), two pairs in each texel.
#include "pass/chains.glsl"

layout(location = 0) out vec4 chain_numbers_next;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int rows = int(CHAIN_PAIRS / 2u);
    ivec2 chain = ivec2(texel.x, texel.y / rows);
    int row = texel.y - chain.y * rows;
    uint first = 2u * uint(row);
    ivec2 source = chain_source(chain);
    vec4 kept = texelFetch(chain_numbers, ivec2(source.x, source.y * rows + row), 0);
    ChainStep step = chain_step_at(chain);
    vec4 proposed = vec4(chain_pair(vec2(kept.x, kept.y), step, first), chain_pair(vec2(kept.z, kept.w), step, first + 1u));
    chain_numbers_next = texelFetch(chain_tails, chain, 0).z > 0.0 ? proposed : kept;
}
