#include "scene.glsl"

// Smooth glass, water, or whatever is clear: reflects by Fresnel and lets through the rest. The shape must be a solid whose
// normals point out of it; from within, the index of refraction is the other way round (surface_material()). A bubble in
// the solid has the index 1 / ior.
Material glass(float ior) {
    Material material = material_new(MATERIAL_GLASS, vec3(1.0));
    material.ior = ior;
    return material;
}

// Lets through `tint` of the light at each passage of the surface.
Material glass_tinted(vec3 tint, float ior) {
    Material material = material_new(MATERIAL_GLASS, tint);
    material.ior = ior;
    return material;
}

// The light's cosine beyond the surface, or 0 where it is reflected totally; `tilt` is the part of the incoming direction along
// the surface.
float glass_cosine(float ior, vec3 tilt) {
    return sqrt(max(1.0 - dot(tilt, tilt) / (ior * ior), 0.0));
}

// Fresnel's reflectance of unpolarised light, from the cosines on both sides; 1 where the one beyond is 0.
float glass_fresnel(float ior, float cos_in, float cos_beyond) {
    float parallel = (ior * cos_in - cos_beyond) / max(ior * cos_in + cos_beyond, 1.0e-20);
    float across = (cos_in - ior * cos_beyond) / max(cos_in + ior * cos_beyond, 1.0e-20);
    return cos_beyond > 0.0 ? 0.5 * (parallel * parallel + across * across) : 1.0;
}

// v.x chooses, in proportion to what goes either way, so that nothing but the tint is left to weigh.
//
// Radiance grows by ior^2 as light enters glass, which gathers it into a narrower cone, and shrinks by as much as it leaves. Both
// ends of a path, the eye and the sky, are in air: whatever enters leaves, the factors cancel, and both are left out.
Bounce glass_sample(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    float ior = material.ior;
    float cos_in = max(-dot(normal, incoming), 0.0);
    vec3 tilt = incoming + cos_in * normal;
    float cos_beyond = glass_cosine(ior, tilt);
    if (v.x < glass_fresnel(ior, cos_in, cos_beyond)) return Bounce(reflect(incoming, normal), vec3(1.0), 0.0, false);
    return Bounce(normalize(tilt / ior - cos_beyond * normal), material.color, 0.0, false);
}

float glass_pdf(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return 0.0;
}

vec3 glass_value(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return vec3(0.0);
}
