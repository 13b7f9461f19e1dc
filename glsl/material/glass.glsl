#include "math/reflect.glsl"
#include "scene.glsl"

// Smooth glass, water, or another clear substance. It reflects as Fresnel's equations say, and lets the rest of the light through.
// The shape must be a solid whose normals point out of it. If a ray comes from within, surface_material() inverts the index of
// refraction. A bubble in the solid has the index 1 / ior.
Material glass(float ior) {
    Material material = material_new(MATERIAL_GLASS, vec3(1.0));
    material.ior = ior;
    return material;
}

// Coloured glass. It lets through the share `tint` of the light each time that light passes its surface.
Material glass_tinted(vec3 tint, float ior) {
    Material material = material_new(MATERIAL_GLASS, tint);
    material.ior = ior;
    return material;
}

// Returns the cosine of the light's direction beyond the surface, or 0 if the light is reflected totally. `tilt` is the part of the
// incoming direction that is parallel to the surface.
float glass_cosine(float ior, vec3 tilt) {
    return sqrt(max(1.0 - dot(tilt, tilt) / (ior * ior), 0.0));
}

// Returns Fresnel's reflectance of unpolarised light, from the cosines on both sides. It is 1 if `cos_beyond` is 0.
float glass_fresnel(float ior, float cos_in, float cos_beyond) {
    float parallel = (ior * cos_in - cos_beyond) / max(ior * cos_in + cos_beyond, 1.0e-20);
    float across = (cos_in - ior * cos_beyond) / max(cos_in + ior * cos_beyond, 1.0e-20);
    float reflectance = 0.5 * (parallel * parallel + across * across);
    return cos_beyond > 0.0 ? reflectance : 1.0;
}

// v.x chooses between reflection and refraction, in proportion to the light that goes either way. The weight is therefore the tint alone.
//
// Radiance grows by ior^2 when light enters glass, because glass gathers the light into a narrower cone. It shrinks by the same factor
// when the light leaves. Both ends of a path, the eye and the sky, are in air, so the factors cancel and are left out.
Bounce glass_sample(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    float ior = material.ior;
    float cos_in = max(-dot(normal, incoming), 0.0);
    vec3 tilt = incoming + cos_in * normal;
    float cos_beyond = glass_cosine(ior, tilt);
    if (v.x < glass_fresnel(ior, cos_in, cos_beyond)) return Bounce(mirror_direction(incoming, normal), vec3(1.0), 0.0, false);
    return Bounce(normalize(tilt / ior - cos_beyond * normal), material.color, 0.0, false);
}

float glass_pdf(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return 0.0;
}

vec3 glass_value(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return vec3(0.0);
}
