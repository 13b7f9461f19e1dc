#include "scene.glsl"

// A lamp. It emits `radiance` to both sides and in all directions alike, and reflects nothing. A scene that wants one side to be
// dark tests hit.inside. The hint `emitter-sphere` tells paths where the lamp is; without the hint, only random bounces find it.
Material emitter(vec3 radiance) {
    return material_new(MATERIAL_EMITTER, radiance);
}

// Returns the radiance toward the ray's origin. Only materials that emit have this function.
vec3 emitter_emitted(Material material, vec3 normal, vec3 incoming) {
    return material.color;
}

// Never throws light that comes from elsewhere.
const bool EMITTER_THROWS = false;

Bounce emitter_sample(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    return Bounce(normal, vec3(0.0), 0.0, false);
}

float emitter_pdf(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return 0.0;
}

vec3 emitter_value(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return vec3(0.0);
}
