// Every hit sends a ray toward one of the spheres that the scene names as emitters (`emitter-sphere`). Bounces may find the same
// light, so the two are weighted by multiple importance sampling with the balance heuristic (Veach 1997).
//
// A sphere is a hint, and a wrong one costs time but does not change the mean: the ray finds whatever emits in its direction, and
// what emits elsewhere is left to the bounces.
#include "emission/met.glsl"
#include "light/through.glsl"
#include <emitter-spheres>
#include "emission/cones.glsl"

bool emission_sought() {
    return true;
}

vec3 emission_direction(Hit hit, INOUT(Sequence) sequence) {
    return emitters_sample(hit.position, hit.normal, sequence_pair(sequence));
}

vec3 emission_reflected(Hit hit, Material material, vec3 incoming, vec3 direction, float bounce_pdf) {
    float pdf = emitters_pdf(hit.position, hit.normal, direction);
    vec3 value = material_value(material, hit.normal, incoming, direction);
    vec3 reflected = vec3(0.0);
    if (pdf > 0.0 && max(value.x, max(value.y, value.z)) > 0.0) {
        Ray ray = ray_from(hit, direction);
        Hit lamp = surface_hit(ray);
        reflected = value * emission_met(lamp, direction, 1.0 / (pdf + bounce_pdf)) * light_through(ray, lamp.t);
    }
    return reflected;
}

float emission_share(Hit hit, Bounce bounce) {
    float pdf = emitters_pdf(hit.position, hit.normal, bounce.direction);
    float share = bounce.pdf / (bounce.pdf + pdf);
    return bounce.pdf > 0.0 ? share : 1.0;
}
