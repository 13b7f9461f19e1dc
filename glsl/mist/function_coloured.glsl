// Mist whose density the scene defines and whose extinction has a colour: the tracks of function.glsl for three channels at once.
//
// The annotation's largest extinction makes the steps. A channel is taken at random, and its extinction alone decides which of the steps is real. The probabilities of
// the track in all channels are kept, and what a path weighs is its channel's over their mean (channels.glsl).
#include "mist/channels.glsl"
#include "mist/function_density.glsl"
#include "mist/material.glsl"

// What a channel keeps on the whole way, what it has lost at the first real scattering, and where that is; with INFINITY the second is what it keeps, too.
struct MistTrack {
    vec3 kept;
    vec3 weight;
    float event;
};

MistTrack mist_walk(MistWay way, float depth, uint number, vec3 chosen) {
    MistTrack track = MistTrack(vec3(1.0), vec3(1.0), INFINITY);
    float passed = 0.0;
    int steps = 0;
    bool inside = true;
    while (inside && steps < MIST_STEPS) {
        uvec3 bits = hash_3(uvec3(mist_seed, number, uint(steps)));
        passed += depth_taking(unit_float(bits.x));
        inside = passed < depth;
        if (inside) {
            float t = way.begin + min(mist_reached(way, passed), way.metres);
            vec3 share = clamp(mist_density(way.ray, t), 0.0, 1.0) * mist_tint();
            bool waits = track.event >= INFINITY;
            bool first = waits && unit_float(bits.y) < dot(share, chosen);
            track.event = first ? t : track.event;
            track.weight = first ? track.weight * share : waits ? track.weight * (1.0 - share) : track.weight;
            track.kept *= 1.0 - share;
        }
        steps += 1;
    }
    return track;
}

vec3 mist_kept(MistWay way) {
    mist_track += 1u;
    return mist_walk(way, way.depth, mist_track, vec3(0.0)).kept;
}

// The place's number is the path's own. u takes the channel.
MistEvent mist_event(MistWay way, vec3 throughput, float u) {
    vec3 odds = channels_odds(throughput);
    MistTrack track = mist_walk(way, way.depth, 0u, vec3(channels_choice(odds, u)));
    return MistEvent(track.event, track.weight / max(dot(odds, track.weight), 1.0e-30));
}

// The place is drawn as if the mist were that of the annotation. The weight makes up for it.
MistPoint mist_point(MistWay way, vec3 throughput, float u) {
    vec3 odds = channels_odds(throughput);
    vec3 depths = way.depth * mist_tint();
    float share = channels_point(depths, odds, u);
    float t = way.begin + min(mist_reached(way, share * way.depth), way.metres);
    float density = clamp(mist_density(way.ray, t), 0.0, 1.0);
    vec3 kept = mist_walk(way, share * way.depth, 1u, vec3(0.0)).kept;
    return MistPoint(t, depths * density * kept / channels_point_pdf(depths, odds, share));
}
