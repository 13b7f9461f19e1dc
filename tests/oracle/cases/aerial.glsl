// a: the height, the slope and the length of a ray, and a random number; b: the altitude of the height 0, and two random numbers.
// c: the depths of red, green and blue, and the place that stands for the way; d: its weight in blue, the place of the event, the event's weight in red, and
// the cosine of a direction by Rayleigh's phase function.
#include "../air.glsl"
#include "../item.glsl"

float base_m = 0.0;

#include "mist/air.glsl"
#include "sky/absorber_ozone.glsl"

Atmosphere air_here() { return air(); }
float air_base_m() { return base_m; }
bool air_scatters_again() { return true; }

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    base_m = b.x;
    Ray ray = Ray(vec3(0.0, a.x, 0.0), vec3(sqrt(max(1.0 - a.y * a.y, 0.0)), a.y, 0.0));
    MistWay way = mist_way(ray, a.z);
    vec3 depths = air_depths(ray, way.metres);
    MistPoint point = mist_point(way, vec3(1.0), a.w);
    MistEvent event = mist_event(way, vec3(1.0), b.y);
    vec3 incoming = vec3(0.6, 0.0, 0.8);
    c = vec4(depths, point.t);
    d = vec4(point.weight.z, event.t < INFINITY ? event.t : -1.0, event.weight.x, dot(incoming, rayleigh_sample(incoming, vec2(b.z, b.w))));
}
