// a: u, and the tilt and azimuth of a normal; b: where it is. c: a direction toward one of the spheres, and its density; d: the
// density of another direction, and how much a rounding grows.
#include "../item.glsl"

const int EMITTER_SPHERES = 3;

vec4 emitter_sphere(int i) {
    return i == 0 ? vec4(0.0, 3.0, 0.0, 1.0) : i == 1 ? vec4(2.0, 2.0, 1.0, 0.2) : vec4(-1.0, 1.0, 1.0, 1.5);
}

#include "emission/cones.glsl"

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    vec3 normal = in_frame(vec3(0.0, 1.0, 0.0), sqrt(1.0 - a.z * a.z) * cos(a.w), sqrt(1.0 - a.z * a.z) * sin(a.w), a.z);
    vec3 position = vec3(b);
    // Close to a sphere its cone is nearly half of all, and a rounding of the distance is much of the angle.
    float condition = 1.0;
    for (int i = 0; i < EMITTER_SPHERES; i++) {
        vec4 sphere = emitter_sphere(i);
        float off = length(position - vec3(sphere)) / sphere.w;
        condition = max(condition, off / abs(off - 1.0));
    }
    vec3 drawn = emitters_sample(position, normal, vec2(a));
    vec3 up = normalize(vec3(0.0, 3.0, 0.0) - position);
    c = vec4(drawn, emitters_pdf(position, normal, up));
    d = vec4(condition, 0.0, 0.0, 0.0);
}
