// Mist within a box along the axes.
#include "shape/interval.glsl"
#include "mist/region.glsl"
#include "mist/values.glsl"

vec2 mist_span(Ray ray) {
    vec3 from = ray.origin - mist_middle();
    vec3 reach = mist_reach();
    Interval x = interval_slab(from.x, ray.direction.x, reach.x, vec3(1.0, 0.0, 0.0));
    Interval y = interval_slab(from.y, ray.direction.y, reach.y, vec3(0.0, 1.0, 0.0));
    Interval z = interval_slab(from.z, ray.direction.z, reach.z, vec3(0.0, 0.0, 1.0));
    return vec2(max(max(x.enter, y.enter), z.enter), min(min(x.leave, y.leave), z.leave));
}
