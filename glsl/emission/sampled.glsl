// Every hit looks for light in the directions of one of the spheres that the scene names (`emitter-sphere`), and so may its bounce:
// multiple importance sampling by the balance heuristic (Veach 1997).
//
// A sphere is a hint: whatever emits in its directions is found, and what emits elsewhere is left to the bounces, so that wrong ones
// do no harm.
#include "emission/met.glsl"
#include "math/cone.glsl"
#include <emitter-spheres>

Cone emitter_cone(int i, vec3 position) {
    vec4 sphere = emitter_sphere(i);
    return cone_toward(position, vec3(sphere), sphere.w); // empty from inside of the sphere
}

// How much light to expect from a cone, for the choice among several: its solid angle by the cosine at its highest. 0 where it is
// below the surface.
float emitter_weight(Cone cone, vec3 normal) {
    float sine = sqrt(cone.one_less_cos * (2.0 - cone.one_less_cos));
    return cone.one_less_cos * clamp(dot(cone.axis, normal) + sine, 0.0, 1.0);
}

// u.x chooses, and stretched serves again: numbers that are spread evenly stay so in each of the parts.
vec3 emission_direction(Hit hit, INOUT(Sequence) sequence) {
    vec2 u = sequence_pair(sequence);
    Cone chosen = Cone(hit.normal, 0.0);
    float total = 0.0;
    for (int i = 0; i < EMITTER_SPHERES; i++) {
        Cone cone = emitter_cone(i, hit.position);
        float weight = emitter_weight(cone, hit.normal);
        total += weight;
        float share = weight / max(total, 1.0e-30); // of those so far
        bool here = u.x < share;
        if (here) chosen = cone;
        u.x = here ? u.x / share : (u.x - share) / max(1.0 - share, 1.0e-7);
    }
    return cone_sample(chosen, u);
}

// The density of these directions, 1/sr.
float emission_pdf(Hit hit, vec3 direction) {
    float density = 0.0;
    float total = 0.0;
    for (int i = 0; i < EMITTER_SPHERES; i++) {
        Cone cone = emitter_cone(i, hit.position);
        float weight = emitter_weight(cone, hit.normal);
        if (weight > 0.0) density += weight * cone_pdf(cone, direction);
        total += weight;
    }
    return density / max(total, 1.0e-30);
}

vec3 emission_reflected(Hit hit, Material material, vec3 incoming, vec3 direction, float bounce_pdf) {
    float pdf = emission_pdf(hit, direction);
    vec3 value = material_value(material, hit.normal, incoming, direction);
    vec3 reflected = vec3(0.0);
    if (pdf > 0.0 && max(value.x, max(value.y, value.z)) > 0.0) {
        Ray ray = ray_from(hit, direction);
        reflected = value * emission_met(surface_hit(ray), direction, 1.0 / (pdf + bounce_pdf));
    }
    return reflected;
}

float emission_share(Hit hit, Bounce bounce) {
    return bounce.pdf > 0.0 ? bounce.pdf / (bounce.pdf + emission_pdf(hit, bounce.direction)) : 1.0;
}
