#include "scene.glsl"

// Where a matte surface scatters to, from u, v in [0,1)^2. The light method defines it: Lambert's cosine, or the
// author's lobe.
vec3 matte_direction(vec3 normal, vec2 u, vec2 v);

// Scatters `albedo` of the light, whichever way it came.
Material matte(vec3 albedo) {
    return Material(MATERIAL_MATTE, albedo);
}

Bounce matte_sample(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    return Bounce(matte_direction(normal, u, v), material.color, true);
}
