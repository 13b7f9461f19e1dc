// a: the height and the slope of a ray, its length in the mist, and where it ends; b: falloff (0: one density), extinction, and two random numbers.
// c: the depth, the place of the event and of the point, and the weight; d: cosine of a turned direction, its density's logarithm, and what Cornette and Shanks's
// function is over it; and how much a rounding of the depth grows.
#include "../item.glsl"

float falloff = 1.0;
float extinction = 1.0;
float forward = 0.0;
float span = 1.0;

#include "mist/height.glsl"
#include "mist/closed.glsl"
#include "mist/phase_shanks.glsl"

float mist_extinction() { return extinction; }
vec3 mist_albedo() { return vec3(0.5); }
float mist_forward() { return forward; }
float mist_falloff() { return falloff; }
float mist_base() { return 0.0; }
vec2 mist_span(Ray ray) { return vec2(0.0, span); }

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    falloff = b.x;
    extinction = b.y;
    span = a.z;
    forward = a.w;
    Ray ray = Ray(vec3(0.0, a.x, 0.0), vec3(sqrt(max(1.0 - a.y * a.y, 0.0)), a.y, 0.0));
    MistWay way = mist_way(ray, INFINITY);
    MistPoint point = mist_point(way, vec3(1.0), b.w);
    float event = mist_event(way, vec3(1.0), b.z).t;
    c = vec4(way.depth, event < INFINITY ? event : -1.0, point.t, point.weight.x);
    vec3 incoming = vec3(0.6, 0.0, 0.8);
    vec3 turned = henyey_sample(forward, incoming, vec2(b.z, b.w));
    float value = place_mist_value(mist_material(vec3(0.0)), vec3(0.0), incoming, turned).x;
    d = vec4(dot(incoming, turned), log(place_mist_pdf(mist_material(vec3(0.0)), vec3(0.0), incoming, turned)), 2.0 * value / henyey_pdf(forward, incoming, turned), 0.0);
}
