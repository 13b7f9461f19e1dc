#include "light/surface.glsl"

// Bounces as the material draws them.
Bounce path_bounce(int hits, Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    return material_sample(material, normal, incoming, u, v);
}

float path_pdf(int hits, Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return material_pdf(material, normal, incoming, outgoing);
}
