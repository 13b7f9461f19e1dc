#include "math/reflect.glsl"
#include "scene.glsl"

// A perfect mirror that reflects `tint` of the light.
Material mirror(vec3 tint) {
    return material_new(MATERIAL_MIRROR, tint);
}

Bounce mirror_sample(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    return Bounce(mirror_direction(incoming, normal), material.color, 0.0, false);
}

float mirror_pdf(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return 0.0;
}

vec3 mirror_value(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return vec3(0.0);
}
