// Mist whose depth along a ray, and whose way to a given depth, have closed forms.
#include "mist/ask.glsl"
#include "mist/material/mist.glsl"
#include "mist/quotient.glsl"
#include "mist/values.glsl"

// The length of the way's beginning that has this depth, which is at most that of the way.
float mist_reached(MistWay way, float depth);

bool mist_here() {
    return true;
}

float mist_kept(MistWay way) {
    return exp(-way.depth);
}

// The depth before the event is distributed as exp(-depth).
float mist_event(MistWay way, float u) {
    float depth = u * log_quotient(u);
    return depth < way.depth ? way.begin + min(mist_reached(way, depth), way.length) : INFINITY;
}

// The depth is distributed as exp(-depth) within the way. The weight is then the same everywhere.
MistPoint mist_point(MistWay way, float u) {
    float taken = way.depth < 60.0 ? way.depth * exp_quotient(way.depth) : 1.0;
    float part = u * taken;
    float depth = min(part * log_quotient(part), way.depth);
    return MistPoint(way.begin + min(mist_reached(way, depth), way.length), taken);
}

Material mist_material() {
    return material_new(MATERIAL_MIST, mist_albedo());
}
