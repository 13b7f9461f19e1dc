#version 330 core
// Proposes a path to each chain, one in each texel, and decides whether the chain takes it. While the chains look for their start, the paths are its
// candidates. Afterwards each step brings two points of light to the picture: the proposed path, weighed by the probability that it is taken, and the path
// before it by the rest.
#include "scene.glsl"
#include "pass/chains.glsl"

// Where the path before the step is kept.
ivec2 chain_before = ivec2(0);

vec2 chain_kept(uint dimension) {
    vec4 pairs = texelFetch(chain_numbers, ivec2(chain_before.x, chain_before.y * int(CHAIN_PAIRS / 2u) + int(dimension / 2u)), 0);
    return (dimension & 1u) == 0u ? vec2(pairs.x, pairs.y) : vec2(pairs.z, pairs.w);
}

#include "sequence/chain.glsl"
#include <sky>
#include <inputs>
#include <scene>
#include <spheres>
#include <bounds>
#include <mist>
#include <materials>
#include <sun>
#include <emission>
#include <light>
#include "pass/camera.glsl"
#include "pass/light_point.glsl"
#include <loops>

uniform int max_hits;

// The light that the proposed path brings to the picture's sum in 1 step, and in alpha its pixel; and the same for the path before it.
layout(location = 0) out vec4 chain_point_new;
layout(location = 1) out vec4 chain_point_old;
layout(location = 2) out vec4 chain_light_next;
layout(location = 3) out vec4 chain_tail_next;

// The place in the picture that a path's first pair of numbers names, in pixels from the top left corner.
vec2 chain_place(vec2 first) {
    return first * vec2(picture_size.x, picture_size.y);
}

// The point of light of a path with this radiance, for `share` of a step.
vec4 chain_point(vec2 first, vec3 radiance, float share) {
    float brightness = chain_brightness(radiance);
    float scale = share * picture_size.x * picture_size.y;
    return vec4(brightness > 0.0 ? radiance / brightness * scale : vec3(0.0), light_point_pixel(chain_place(first)));
}

void main() {
    ivec2 chain = ivec2(gl_FragCoord.xy);
    chain_before = chain_source(chain);
    vec4 before = chain_age > 0u ? texelFetch(chain_lights, chain_before, 0) : vec4(0.0);
    vec4 tail = texelFetch(chain_tails, chain_before, 0);
    ChainStep step = chain_step_at(chain);
    Sequence sequence = sequence_of_chain(step, uvec2(uint(tail.x), uint(tail.y)));
    vec2 first = sequence_pair(sequence);
    vec2 pixel = floor(chain_place(first));
    vec3 radiance = path_radiance(camera_ray(pixel, chain_place(first) - pixel), max_hits, sequence);
    float brightness = chain_brightness(radiance);
    // What is brighter would make sums too large for a float: that of the candidates, or that of a pixel in one step.
    bool counts = brightness < 1.0e38 / (float(chain_candidates) * picture_size.x * picture_size.y) && !loops_ended();
    radiance = counts ? radiance : vec3(0.0);
    brightness = counts ? brightness : 0.0;

    bool starts = chain_starts();
    float probability = starts ? chain_choice(before.a, brightness) : chain_acceptance(chain_brightness(vec3(before)), brightness);
    bool taken = step.threshold < probability;
    float weight = starts ? 0.0 : chain_age == chain_candidates ? chain_mean : before.a;
    // The host counts points that are no numbers as rejected.
    chain_point_new = counts ? chain_point(first, radiance, weight * probability)
                             : vec4(vec3(uintBitsToFloat(0x7fc00000u)), light_point_pixel(chain_place(first)));
    chain_point_old = chain_point(chain_kept(0u), vec3(before), weight * (1.0 - probability));
    chain_light_next = vec4(taken ? radiance : vec3(before), starts ? before.a + brightness : weight);
    chain_tail_next = vec4(taken ? vec2(float(sequence.tail.x), float(sequence.tail.y)) : vec2(tail.x, tail.y), taken ? 1.0 : 0.0, 0.0);
}
