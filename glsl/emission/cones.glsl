// The directions of the spheres that a scene names as emitters. Who includes this defines them before: const int EMITTER_SPHERES, and
// vec4 emitter_sphere(int i), centre and radius.
#include "math/cone.glsl"

Cone emitter_cone(int i, vec3 position) {
    vec4 sphere = emitter_sphere(i);
    return cone_toward(position, vec3(sphere), sphere.w); // empty from inside of the sphere
}

// How much light to expect from a cone, for the choice among several: its solid angle by the cosine at its highest. 0 where it is
// below the surface.
float emitter_weight(Cone cone, vec3 normal) {
    float sine = sqrt(max(cone.one_less_cos * (2.0 - cone.one_less_cos), 0.0));
    return cone.one_less_cos * clamp(dot(cone.axis, normal) + sine, 0.0, 1.0);
}

// A direction in one of the cones, from u in [0,1)^2. u.x chooses, and stretched serves again: numbers that are spread evenly stay
// so in each of the parts.
vec3 emitters_sample(vec3 position, vec3 normal, vec2 u) {
    Cone chosen = Cone(normal, 0.0);
    float total = 0.0;
    for (int i = 0; i < EMITTER_SPHERES; i++) {
        Cone cone = emitter_cone(i, position);
        float weight = emitter_weight(cone, normal);
        total += weight;
        float share = weight / max(total, 1.0e-30); // of those so far
        bool here = u.x < share;
        if (here) chosen = cone;
        u.x = here ? u.x / share : (u.x - share) / max(1.0 - share, 1.0e-7);
    }
    return cone_sample(chosen, u);
}

// The density of that, 1/sr; 0 everywhere where all cones are empty.
float emitters_pdf(vec3 position, vec3 normal, vec3 direction) {
    float density = 0.0;
    float total = 0.0;
    for (int i = 0; i < EMITTER_SPHERES; i++) {
        Cone cone = emitter_cone(i, position);
        float weight = emitter_weight(cone, normal);
        if (weight > 0.0) density += weight * cone_pdf(cone, direction);
        total += weight;
    }
    return density / max(total, 1.0e-30);
}
