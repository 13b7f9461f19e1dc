// Mist that thins with height: its extinction falls as exp(-y / falloff).
#include "mist/ask.glsl"
#include "mist/quotient.glsl"
#include "mist/region.glsl"
#include "mist/values.glsl"

// A power of e that no mist needs, and whose product with the farthest distance is a float.
const float HEIGHT_MOST_POWER = 60.0;

// Along a ray the extinction is an exponential of the distance too, and so the depth is one in closed form.
MistWay mist_way(Ray ray, float distance) {
    vec2 part = mist_part(ray, distance);
    float height = ray.origin.y + part.x * ray.direction.y - mist_base();
    float extinction = mist_extinction() * exp(min(-height / mist_falloff(), HEIGHT_MOST_POWER));
    float fall = ray.direction.y / mist_falloff();
    return MistWay(ray, part.x, part.y, extinction * part.y * exp_quotient(fall * part.y), extinction, fall);
}

float mist_reached(MistWay way, float depth) {
    float level = depth / max(way.extinction, 1.0e-30);
    return level * log_quotient(min(level * way.fall, 0.999999));
}
