#include "scene.glsl"

// Emits `radiance` to both sides, the same in all directions, and reflects nothing. A scene that wants one side dark asks
// hit.inside. `emitter-sphere` says where paths may look for it; without, they find it by chance.
Material emitter(vec3 radiance) {
    return material_new(MATERIAL_EMITTER, radiance);
}

// Radiance toward where the ray came from: a function that a material need not have.
vec3 emitter_emitted(Material material, vec3 normal, vec3 incoming) {
    return material.color;
}

Bounce emitter_sample(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    return Bounce(normal, vec3(0.0), 0.0, false);
}

float emitter_pdf(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return 0.0;
}

vec3 emitter_value(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return vec3(0.0);
}
