// Mist whose density the scene defines: float scene_mist(vec3 p) is the share, from 0 to 1, of the extinction that the annotation states.
//
// The depth of such mist has no formula. So a track goes through the mist that the annotation states, from one scattering to the next, and each of
// them is real with the probability scene_mist(). The first real one is where light is scattered (delta tracking, Woodcock 1965). The product of what is left
// at each, 1 - scene_mist(), is an estimate of the transmittance with the right mean (ratio tracking, Novak, Selle and Jarosz 2014).
#include "mist/function_density.glsl"
#include "mist/material.glsl"

vec3 mist_kept(MistWay way) {
    mist_track += 1u;
    float kept = 1.0;
    MistStep at = mist_step_first(way, mist_track);
    while (at.inside && kept > 0.0) {
        kept *= 1.0 - mist_step_share(way, at);
        at = mist_step_next(way, at);
    }
    return vec3(kept);
}

// The numbers are the path's own, so that u has no use.
MistEvent mist_event(MistWay way, vec3 throughput, float u) {
    float t = INFINITY;
    MistStep at = mist_step_first(way, 0u);
    while (at.inside && t >= INFINITY) {
        t = at.chance < mist_step_share(way, at) ? mist_step_place(way, at) : t;
        at = mist_step_next(way, at);
    }
    return MistEvent(t, vec3(1.0));
}

// A track's steps take away its light: each the share scene_mist() of what the steps before have left. One of them is taken in proportion to that, and it stands
// for all that the track takes away. Most tracks through thin mist have no step. So the first step is drawn as if there were one, and the weight makes up for it.
MistPoint mist_point(MistWay way, vec3 throughput, float u) {
    float forced = share_taken(way.depth), kept = 1.0, t = way.begin;
    MistStep at = mist_step_forced(way, 1u, u * forced);
    while (at.inside && kept > 0.0) {
        float lost = kept * mist_step_share(way, at);
        kept -= lost;
        t = at.chance * (1.0 - kept) < lost ? mist_step_place(way, at) : t;
        at = mist_step_next(way, at);
    }
    return MistPoint(t, vec3(forced * (1.0 - kept)));
}
