// Mist within a sphere.
#include "shape/interval.glsl"
#include "mist/region.glsl"
#include "mist/values.glsl"

vec2 mist_span(Ray ray) {
    Interval inside = interval_sphere(mist_middle() - ray.origin, ray.direction, mist_reach().x);
    return vec2(inside.enter, inside.leave);
}
