// Places in mist whose extinction has a colour. `depths` are a way's depths by channel, and a place is told by its share of the way, from 0 to 1, along which each
// channel's depth is taken to grow evenly.
//
// A channel is taken at random, with odds in proportion to what the path is worth in it, and a place is drawn by that channel's depth alone. Its density is the mean of the
// three channels' densities by the same odds (the balance heuristic of Veach 1997, over channels). So the sum of what a path is worth in the channels never grows.
#include "mist/quotient.glsl"

// The odds of a path of this throughput.
vec3 channels_odds(vec3 throughput) {
    float sum = throughput.x + throughput.y + throughput.z;
    return sum > 1.0e-30 && sum < INFINITY ? throughput / sum : vec3(1.0 / 3.0);
}

// 1 for the channel that u in [0, 1) takes, and 0 for the others; and in w the number in [0, 1) that is left of u.
vec4 channels_choice(vec3 odds, float u) {
    float two = odds.x + odds.y;
    vec3 chosen = vec3(u < odds.x ? 1.0 : 0.0, u >= odds.x && u < two ? 1.0 : 0.0, u >= two ? 1.0 : 0.0);
    float rest = (u - dot(chosen, vec3(0.0, odds.x, two))) / max(dot(chosen, odds), 1.0e-30);
    return vec4(chosen, clamp(rest, 0.0, 0.99999994));
}

// Draws the place where light is first scattered or absorbed; INFINITY if that is behind the way.
float channels_event(vec3 depths, vec3 odds, float u) {
    vec4 choice = channels_choice(odds, u);
    float whole = dot(vec3(choice), depths);
    float depth = depth_taking(choice.w);
    return depth < whole ? depth / whole : INFINITY;
}

float channels_event_pdf(vec3 depths, vec3 odds, float share) {
    return dot(odds, depths * exp(-depths * share));
}

// The probability that there is no such place.
float channels_none(vec3 depths, vec3 odds) {
    return dot(odds, exp(-depths));
}

// Draws a place with a density in proportion to the light that it takes away from a channel.
float channels_point(vec3 depths, vec3 odds, float u) {
    vec4 choice = channels_choice(odds, u);
    float whole = dot(vec3(choice), depths);
    float share = depth_taking(choice.w * share_taken(whole)) / max(whole, 1.0e-30);
    // A channel that loses nothing takes all places alike.
    return whole > 1.0e-6 ? min(share, 1.0) : choice.w;
}

float channels_point_pdf(vec3 depths, vec3 odds, float share) {
    vec3 taken = vec3(exp_quotient(depths.x), exp_quotient(depths.y), exp_quotient(depths.z));
    return dot(odds, exp(-depths * share) / max(taken, 1.0e-30));
}
