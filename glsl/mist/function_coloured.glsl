// Mist whose density the scene defines and whose extinction has a colour: the tracks of function.glsl for three channels at once.
//
// The annotation's largest extinction makes the steps. A channel is taken at random, and its extinction alone decides which of the steps is real. The probabilities of
// the track in all channels are kept, and what a path weighs is its channel's over their mean (channels.glsl).
#include "mist/channels.glsl"
#include "mist/function_density.glsl"
#include "mist/material.glsl"

vec3 mist_kept(MistWay way) {
    mist_track += 1u;
    vec3 kept = vec3(1.0);
    MistStep at = mist_step_first(way, mist_track);
    while (at.inside) {
        kept *= 1.0 - mist_step_share(way, at) * mist_tint();
        at = mist_step_next(way, at);
    }
    return kept;
}

// The place's number is the path's own. u takes the channel.
MistEvent mist_event(MistWay way, vec3 throughput, float u) {
    vec3 odds = channels_odds(throughput);
    vec3 chosen = vec3(channels_choice(odds, u));
    vec3 weight = vec3(1.0);
    float t = INFINITY;
    MistStep at = mist_step_first(way, 0u);
    while (at.inside && t >= INFINITY) {
        vec3 share = mist_step_share(way, at) * mist_tint();
        bool real = at.chance < dot(share, chosen);
        t = real ? mist_step_place(way, at) : t;
        weight *= real ? share : 1.0 - share;
        at = mist_step_next(way, at);
    }
    return MistEvent(t, weight / max(dot(odds, weight), 1.0e-30));
}

// As in function.glsl, with the odds' mean of what the channels lose.
MistPoint mist_point(MistWay way, vec3 throughput, float u) {
    vec3 odds = channels_odds(throughput);
    vec3 kept = vec3(1.0), weight = vec3(0.0);
    float forced = share_taken(way.depth), taken = 0.0, t = way.begin;
    MistStep at = mist_step_forced(way, 1u, u * forced);
    while (at.inside) {
        vec3 lost = kept * mist_step_share(way, at) * mist_tint();
        float mean = dot(odds, lost);
        taken += mean;
        bool here = at.chance * taken < mean;
        t = here ? mist_step_place(way, at) : t;
        weight = here ? lost / mean : weight;
        kept -= lost;
        at = mist_step_next(way, at);
    }
    return MistPoint(t, forced * taken * weight);
}
