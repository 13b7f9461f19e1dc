// Mist whose density the scene defines: float scene_mist(vec3 p) is the share, from 0 to 1, of the extinction that the annotation states.
//
// The depth of such mist has no formula. So a track goes through the mist that the annotation states, from one scattering to the next, and each of
// them is real with the probability scene_mist(). The first real one is where light is scattered (delta tracking, Woodcock 1965). The product of what is left
// at each, 1 - scene_mist(), is an estimate of the transmittance with the right mean (ratio tracking, Novak, Selle and Jarosz 2014).
#include "mist/function_density.glsl"
#include "mist/material.glsl"

// A track through the first `depth` of a way: the share of the light that comes through, and the first real scattering, in metres along the ray.
struct MistTrack {
    float kept;
    float event;
};

MistTrack mist_walk(MistWay way, float depth, uint number) {
    MistTrack track = MistTrack(1.0, INFINITY);
    float passed = 0.0;
    int steps = 0;
    bool inside = true;
    while (inside && steps < MIST_STEPS) {
        uvec3 bits = hash_3(uvec3(mist_seed, number, uint(steps)));
        passed += depth_taking(unit_float(bits.x));
        inside = passed < depth;
        if (inside) {
            float t = way.begin + min(mist_reached(way, passed), way.metres);
            float share = clamp(mist_density(way.ray, t), 0.0, 1.0);
            bool first = track.event >= INFINITY && unit_float(bits.y) < share;
            track.event = first ? t : track.event;
            track.kept *= 1.0 - share;
        }
        steps += 1;
    }
    return track;
}

vec3 mist_kept(MistWay way) {
    mist_track += 1u;
    return vec3(mist_walk(way, way.depth, mist_track).kept);
}

// The numbers are the path's own, so that u has no use.
MistEvent mist_event(MistWay way, vec3 throughput, float u) {
    return MistEvent(mist_walk(way, way.depth, 0u).event, vec3(1.0));
}

// The place is drawn as if the mist were that of the annotation. The weight makes up for it.
MistPoint mist_point(MistWay way, vec3 throughput, float u) {
    float taken = share_taken(way.depth);
    float depth = min(depth_taking(u * taken), way.depth);
    float t = way.begin + min(mist_reached(way, depth), way.metres);
    float share = clamp(mist_density(way.ray, t), 0.0, 1.0);
    return MistPoint(t, vec3(taken * share * exp(depth) * mist_walk(way, depth, 1u).kept));
}
