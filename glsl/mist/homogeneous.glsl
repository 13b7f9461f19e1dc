// Mist of one density.
#include "mist/ask.glsl"
#include "mist/region.glsl"
#include "mist/values.glsl"

MistWay mist_way(Ray ray, float distance) {
    vec2 part = mist_part(ray, distance);
    float extinction = mist_extinction();
    return MistWay(ray, part.x, part.y, extinction * part.y, extinction, 0.0);
}

float mist_reached(MistWay way, float depth) {
    return depth / max(way.extinction, 1.0e-30);
}
