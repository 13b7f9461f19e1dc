// Directions toward the spheres that a scene names as emitters. The file that includes this one first defines const int
// EMITTER_SPHERES and vec4 emitter_sphere(int i), which is centre and radius.
#include "math/cone.glsl"

Cone emitter_cone(int i, vec3 position) {
    vec4 sphere = emitter_sphere(i);
    // The cone is empty if the position is inside the sphere.
    return cone_toward(position, vec3(sphere), sphere.w);
}

// The light to expect from a cone, for the choice among several: its solid angle times the cosine at its highest point. It is 0 for
// a cone below the surface.
float emitter_weight(Cone cone, vec3 normal) {
    float sine = sqrt(max(cone.one_less_cos * (2.0 - cone.one_less_cos), 0.0));
    return cone.one_less_cos * clamp(dot(cone.axis, normal) + sine, 0.0, 1.0);
}

// A direction in one of the cones, from u in [0,1)^2. u.x chooses the cone and is then stretched and used again: numbers that are
// evenly spread stay so within each part.
vec3 emitters_sample(vec3 position, vec3 normal, vec2 u) {
    Cone chosen = Cone(normal, 0.0);
    float total = 0.0;
    for (int i = 0; i < EMITTER_SPHERES; i++) {
        Cone cone = emitter_cone(i, position);
        float weight = emitter_weight(cone, normal);
        total += weight;
        // The share among the cones so far.
        float share = weight / max(total, 1.0e-30);
        bool here = u.x < share;
        if (here) chosen = cone;
        float below = u.x / share;
        float above = (u.x - share) / max(1.0 - share, 1.0e-7);
        u.x = here ? below : above;
    }
    return cone_sample(chosen, u);
}

// The density of emitters_sample(), 1/sr. It is 0 everywhere if all cones are empty.
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
