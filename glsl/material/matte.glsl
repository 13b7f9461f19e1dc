#include "scene.glsl"

// The direction in which a matte surface scatters, drawn from u and v in [0,1)^2, and its density in 1/sr.
// The light method defines both functions, by Lambert's cosine or by the author's lobe.
vec3 matte_direction(vec3 normal, vec2 u, vec2 v);
float matte_density(float cosine);

// A matte surface. It scatters the share `albedo` of the light, from whichever direction the light comes.
Material matte(vec3 albedo) {
    return material_new(MATERIAL_MATTE, albedo);
}

// Never throws light in narrow lobes.
const bool MATTE_THROWS = false;

Bounce matte_sample(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    vec3 direction = matte_direction(normal, u, v);
    return Bounce(direction, material.color, matte_density(dot(direction, normal)), true);
}

float matte_pdf(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return matte_density(dot(outgoing, normal));
}

vec3 matte_value(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return matte_density(dot(outgoing, normal)) * material.color;
}
