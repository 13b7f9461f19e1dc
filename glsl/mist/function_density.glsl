// The density that the scene defines, and the steps of tracks through it (function.glsl, function_coloured.glsl).
#include "mist/ask.glsl"
#include "mist/quotient.glsl"
#include "mist/values.glsl"
#include "math/hash.glsl"

float scene_mist(vec3 p);

// A track takes no more steps (src/render/plan.c counts with them). It needs about as many as the depth of the mist that the annotation states.
const int MIST_STEPS = 64;
// mist_overrun() follows a track so far (src/render/check.c counts with them).
const int MIST_STEPS_CHECKED = 512;

// What the random numbers of tracks are made of: a part of the path, and the number of the track in it. The first two belong to the path itself.
uint mist_seed = 0u;
uint mist_track = 2u;

void mist_begin(vec2 numbers) {
    mist_seed = hash_3(uvec3(floatBitsToUint(numbers.x), floatBitsToUint(numbers.y), 0u)).x;
    mist_track = 2u;
}

// A step of a track: a scattering in the mist that the annotation states.
struct MistStep {
    uint track;
    int number;
    // The depth before it, in the mist that the annotation states.
    float passed;
    // A random number from [0, 1) for what happens there.
    float chance;
    // Whether it lies on the way. If not, the track has ended.
    bool inside;
};

MistStep mist_step_at(MistWay way, uint track, int number, float passed, float chance) {
    return MistStep(track, number, passed, chance, passed < way.depth && number < MIST_STEPS);
}

MistStep mist_step_first(MistWay way, uint track) {
    uvec3 bits = hash_3(uvec3(mist_seed, track, 0u));
    return mist_step_at(way, track, 0, depth_taking(unit_float(bits.x)), unit_float(bits.y));
}

// The first step where the stated mist takes away this share of the light, which is below that of all the way.
MistStep mist_step_forced(MistWay way, uint track, float share) {
    uvec3 bits = hash_3(uvec3(mist_seed, track, 0u));
    return mist_step_at(way, track, 0, depth_taking(share), unit_float(bits.y));
}

MistStep mist_step_next(MistWay way, MistStep last) {
    int number = last.number + 1;
    uvec3 bits = hash_3(uvec3(mist_seed, last.track, uint(number)));
    return mist_step_at(way, last.track, number, last.passed + depth_taking(unit_float(bits.x)), unit_float(bits.y));
}

// Metres along the ray.
float mist_step_place(MistWay way, MistStep at) {
    return way.begin + min(mist_reached(way, at.passed), way.metres);
}

float mist_density(Ray ray, float t) {
    return scene_mist(ray.origin + t * ray.direction);
}

// The share of the stated extinction there.
float mist_step_share(MistWay way, MistStep at) {
    return clamp(mist_density(way.ray, mist_step_place(way, at)), 0.0, 1.0);
}

float mist_excess(Ray ray, float distance, float u) {
    MistWay way = mist_way(ray, distance);
    float density = mist_density(ray, way.begin + min(mist_reached(way, u * way.depth), way.metres));
    return way.depth > 0.0 ? max(density - 1.0, -density) : 0.0;
}

float mist_overrun(Ray ray, float distance) {
    mist_track += 1u;
    MistWay way = mist_way(ray, distance);
    vec3 kept = vec3(1.0), behind = vec3(1.0);
    MistStep at = mist_step_first(way, mist_track);
    at.inside = at.passed < way.depth;
    while (at.inside) {
        vec3 keeps = 1.0 - mist_step_share(way, at) * mist_tint();
        bool seen = at.number < MIST_STEPS;
        kept *= seen ? keeps : vec3(1.0);
        behind *= seen ? vec3(1.0) : keeps;
        at = mist_step_next(way, at);
        at.inside = at.passed < way.depth && at.number < MIST_STEPS_CHECKED;
    }
    vec3 excess = kept * (1.0 - behind);
    return max(excess.x, max(excess.y, excess.z));
}
