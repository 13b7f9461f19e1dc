#include "scene.glsl"

// Where a matte surface scatters to, from u, v in [0,1)^2, and how densely, 1/sr. The light method defines them: Lambert's
// cosine, or the author's lobe.
vec3 matte_direction(vec3 normal, vec2 u, vec2 v);
float matte_density(float cosine);

// Scatters `albedo` of the light, whichever way it came.
Material matte(vec3 albedo) {
    return material_new(MATERIAL_MATTE, albedo);
}

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
