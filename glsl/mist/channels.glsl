// Places in mist whose extinction has a colour. `depths` are a way's depths by channel, and a place is told by its share of the way, from 0 to 1, along which each
// channel's depth is taken to grow evenly.
//
// A channel is taken at random, and a place is drawn by its depth alone. Its density is the mean of the three channels' densities, so that what a path
// weighs in any channel stays below 3 (the balance heuristic of Veach 1997, over channels).
#include "mist/quotient.glsl"

float channels_mean(vec3 values) {
    return dot(values, vec3(1.0 / 3.0));
}

// The channel's depth, and in y the number u in [0, 1) that is left of the one that chose it.
vec2 channels_choice(vec3 depths, float u) {
    float three = 3.0 * u;
    float depth = three < 1.0 ? depths.x : three < 2.0 ? depths.y : depths.z;
    return vec2(depth, min(fract(three), 0.99999994));
}

// Draws the place where light is first scattered or absorbed; INFINITY if that is behind the way.
float channels_event(vec3 depths, float u) {
    vec2 choice = channels_choice(depths, u);
    float depth = depth_taking(choice.y);
    return depth < choice.x ? depth / choice.x : INFINITY;
}

float channels_event_pdf(vec3 depths, float share) {
    return channels_mean(depths * exp(-depths * share));
}

// The probability that there is no such place.
float channels_none(vec3 depths) {
    return channels_mean(exp(-depths));
}

// Draws a place with a density in proportion to the light that it takes away from a channel.
float channels_point(vec3 depths, float u) {
    vec2 choice = channels_choice(depths, u);
    float share = depth_taking(choice.y * share_taken(choice.x)) / max(choice.x, 1.0e-30);
    // A channel that loses nothing takes all places alike.
    return choice.x > 1.0e-6 ? min(share, 1.0) : choice.y;
}

float channels_point_pdf(vec3 depths, float share) {
    vec3 taken = vec3(exp_quotient(depths.x), exp_quotient(depths.y), exp_quotient(depths.z));
    return channels_mean(exp(-depths * share) / max(taken, 1.0e-30));
}
