// A place in the mist, as a path meets it. Light methods, the sun and lamps need not know that it is no surface: where a surface has f cos, mist has
// its albedo times the phase function. It has no normal. A scene may have materials of its own named mist and air.
#include "mist/phase.glsl"
#include "mist/values.glsl"
#include "scene.glsl"

const bool PLACE_MIST_THROWS = false;

float mist_phase_weight(float g, float cosine);

Bounce place_mist_sample(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    float g = mist_forward();
    vec3 direction = henyey_sample(g, incoming, u);
    float weight = mist_phase_weight(g, dot(incoming, direction));
    return Bounce(direction, weight * material.color, henyey_pdf(g, incoming, direction), false);
}

float place_mist_pdf(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return henyey_pdf(mist_forward(), incoming, outgoing);
}

vec3 place_mist_value(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    float g = mist_forward();
    return henyey_pdf(g, incoming, outgoing) * mist_phase_weight(g, dot(incoming, outgoing)) * material.color;
}
