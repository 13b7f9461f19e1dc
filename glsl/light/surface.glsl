#include "math/finite.glsl"
#include "scene.glsl"

// What a light method asks of a scene and its materials.
void scene_intersect(Ray ray, INOUT(Hit) hit);
Material scene_material(Hit hit);
// f cos / pdf and direction of a bounce, from u, v in [0,1)^2; the density of its direction, 1/sr; f cos. The last two know
// nothing of a mirror's one direction.
Bounce material_sample(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v);
float material_pdf(Material material, vec3 normal, vec3 incoming, vec3 outgoing);
vec3 material_value(Material material, vec3 normal, vec3 incoming, vec3 outgoing);
// The share of the light that a material throws in narrow lobes, if its bounces have a density. One without throws all in one direction.
float material_throws(Material material);
vec3 sky_radiance(vec3 direction);

// Returns the nearest hit as the scene reports it, and sets only its position. t is INFINITY where there is none.
Hit surface_reported(Ray ray) {
    Hit hit = hit_none();
    scene_intersect(ray, hit);
    hit.position = ray.origin + hit.t * ray.direction;
    return hit;
}

// Returns a hit whose normal has unit length and faces the ray's origin. A scene may report a normal of any length, such as that of
// hit_plane(ray, vec3(0.0, 1.0, 1.0), ...). A normal whose length is 1 up to roundings stays as it is.
Hit surface_faced(Hit hit, Ray ray) {
    float squared = dot(hit.normal, hit.normal);
    vec3 unit = hit.normal * inversesqrt(squared);
    hit.normal = abs(squared - 1.0) > 1.0e-5 && hit.t < INFINITY ? unit : hit.normal;
    hit.inside = dot(hit.normal, ray.direction) > 0.0;
    vec3 opposite = -hit.normal;
    hit.normal = hit.inside ? opposite : hit.normal;
    return hit;
}

// The nearest hit, with its position and its normal toward the ray's origin; t is INFINITY where there is none.
Hit surface_hit(Ray ray) {
    return surface_faced(surface_reported(ray), ray);
}

// No substance bends light more than this.
const float SURFACE_LEAST_IOR = 0.1;

// What is there, as the ray meets it: from within a solid the index of refraction is the other way round. No surface reflects less than no light, or
// more than all. The light of a lamp may be of any strength, so it is taken from scene_material() itself (emission/met.glsl).
Material surface_material(Hit hit) {
    Material material = scene_material(hit);
    // What is no number stays so, for the sample to be left out and counted. clamp() would hide it.
    vec3 numbers = vec3(material.roughness, material.ior, 0.0);
    if (is_finite(material.color) && is_finite(numbers)) {
        material.color = clamp(material.color, 0.0, 1.0);
        material.roughness = clamp(material.roughness, 0.0, 1.0);
        material.ior = max(material.ior, SURFACE_LEAST_IOR);
    }
    float inverse_ior = 1.0 / material.ior;
    material.ior = hit.inside ? inverse_ior : material.ior;
    return material;
}
