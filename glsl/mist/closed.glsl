// Mist whose depth along a ray, and whose way to a given depth, have closed forms.
#include "mist/ask.glsl"
#include "mist/material.glsl"
#include "mist/quotient.glsl"

void mist_begin(vec2 numbers) {
}

vec3 mist_kept(MistWay way) {
    return vec3(exp(-way.depth));
}

// The depth before the event is distributed as exp(-depth).
MistEvent mist_event(MistWay way, vec3 throughput, float u) {
    float depth = depth_taking(u);
    float t = way.begin + min(mist_reached(way, depth), way.metres);
    return MistEvent(depth < way.depth ? t : INFINITY, vec3(1.0));
}

// The depth is distributed as exp(-depth) within the way. The weight is then the same everywhere.
MistPoint mist_point(MistWay way, vec3 throughput, float u) {
    float taken = share_taken(way.depth);
    float depth = min(depth_taking(u * taken), way.depth);
    return MistPoint(way.begin + min(mist_reached(way, depth), way.metres), vec3(taken));
}

float mist_excess(Ray ray, float distance, float u) {
    return 0.0;
}

float mist_overrun(Ray ray, float distance) {
    return 0.0;
}
