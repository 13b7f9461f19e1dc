// Mist whose extinction has a colour, with depths in closed form. All channels thin alike, so that a place's share of the depth is the same in each.
#include "mist/channels.glsl"
#include "mist/material.glsl"

void mist_begin(vec2 numbers) {
}

vec3 mist_kept(MistWay way) {
    return exp(-way.depth * mist_tint());
}

MistEvent mist_event(MistWay way, vec3 throughput, float u) {
    vec3 odds = channels_odds(throughput);
    vec3 depths = way.depth * mist_tint();
    float share = channels_event(depths, odds, u);
    bool scattered = share < INFINITY;
    float inside = min(share, 1.0);
    vec3 there = depths * exp(-depths * inside) / max(channels_event_pdf(depths, odds, inside), 1.0e-30);
    float t = way.begin + min(mist_reached(way, inside * way.depth), way.metres);
    return MistEvent(scattered ? t : INFINITY, scattered ? there : exp(-depths) / max(channels_none(depths, odds), 1.0e-30));
}

MistPoint mist_point(MistWay way, vec3 throughput, float u) {
    vec3 odds = channels_odds(throughput);
    vec3 depths = way.depth * mist_tint();
    float share = channels_point(depths, odds, u);
    float t = way.begin + min(mist_reached(way, share * way.depth), way.metres);
    return MistPoint(t, depths * exp(-depths * share) / channels_point_pdf(depths, odds, share));
}

float mist_excess(Ray ray, float distance, float u) {
    return 0.0;
}

float mist_overrun(Ray ray, float distance) {
    return 0.0;
}
