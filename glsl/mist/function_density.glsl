// The density that the scene defines, and the random numbers of tracks through it (function.glsl, function_coloured.glsl).
#include "mist/ask.glsl"
#include "mist/quotient.glsl"
#include "math/hash.glsl"

float scene_mist(vec3 p);

// A track takes no more steps (src/render/plan.c counts with them). It needs about as many as the depth of the mist that the annotation states.
const int MIST_STEPS = 64;

// What the random numbers of tracks are made of: a part of the path, and the number of the track in it. The first two belong to the path itself.
uint mist_seed = 0u;
uint mist_track = 2u;

void mist_begin(vec2 numbers) {
    mist_seed = hash_3(uvec3(floatBitsToUint(numbers.x), floatBitsToUint(numbers.y), 0u)).x;
    mist_track = 2u;
}

float mist_density(Ray ray, float t) {
    return scene_mist(ray.origin + t * ray.direction);
}

float mist_excess(Ray ray, float distance, float u) {
    MistWay way = mist_way(ray, distance);
    float density = mist_density(ray, way.begin + min(mist_reached(way, u * way.depth), way.metres));
    return way.depth > 0.0 ? max(density - 1.0, -density) : 0.0;
}
