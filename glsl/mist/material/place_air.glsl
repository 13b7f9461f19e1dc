// A place in the atmosphere's air, as a path meets it. Where a surface has f cos, air has its coefficients of scattering, 1/m, times their phase functions. It has no
// normal. Directions are drawn by one of the two phase functions, in proportion to how much they scatter.
#include "mist/phase.glsl"
#include "scene.glsl"
#include "sky/atmosphere.glsl"
#include "sky/phase.glsl"

const bool PLACE_AIR_THROWS = false;

Atmosphere air_here();

// The densities of air and aerosols take the places of two members that air has no use for.
Material air_material(Atmosphere a, vec2 density) {
    Material material = material_new(MATERIAL_PLACE_AIR, vec3(1.0));
    material.roughness = density.x;
    material.ior = density.y;
    return material;
}

// The share of the directions that is drawn as aerosols scatter.
float air_aerosol_share(Material material) {
    Atmosphere a = air_here();
    float air = material.roughness * dot(a.rayleigh_scatter_per_m, vec3(1.0));
    float aerosol = material.ior * dot(a.mie_scatter_per_m, vec3(1.0));
    return aerosol / max(air + aerosol, 1.0e-30);
}

// A direction whose density is Rayleigh's phase function: c + c^3 / 3 of its cosine c is evenly distributed, and Cardano's formula inverts it.
vec3 rayleigh_sample(vec3 incoming, vec2 u) {
    float q = 4.0 * u.x - 2.0;
    // The larger of the two cube roots, and the other by their product.
    float root = pow(abs(q) + sqrt(q * q + 1.0), 1.0 / 3.0);
    float cosine = clamp(sign(q) * (root - 1.0 / root), -1.0, 1.0);
    float sine = sqrt(max((1.0 - cosine) * (1.0 + cosine), 0.0));
    float phi = 2.0 * PI * u.y;
    return normalize(in_frame(incoming, sine * cos(phi), sine * sin(phi), cosine));
}

float place_air_pdf(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    float share = air_aerosol_share(material);
    return mix(rayleigh_phase(incoming, outgoing), henyey_pdf(air_here().mie_g, incoming, outgoing), share);
}

vec3 place_air_value(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    Atmosphere a = air_here();
    return material.color * (a.rayleigh_scatter_per_m * (material.roughness * rayleigh_phase(incoming, outgoing)) +
                             a.mie_scatter_per_m * (material.ior * mie_phase(a.mie_g, incoming, outgoing)));
}

Bounce place_air_sample(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    vec3 direction = rayleigh_sample(incoming, u);
    if (v.x < air_aerosol_share(material)) direction = henyey_sample(air_here().mie_g, incoming, u);
    float pdf = place_air_pdf(material, normal, incoming, direction);
    return Bounce(direction, place_air_value(material, normal, incoming, direction) / max(pdf, 1.0e-30), pdf, false);
}
