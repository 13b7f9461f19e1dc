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

// The nearest hit, with its position and its normal toward the ray's origin; t is INFINITY where there is none.
Hit surface_hit(Ray ray) {
    Hit hit = hit_none();
    scene_intersect(ray, hit);
    hit.position = ray.origin + hit.t * ray.direction;
    hit.inside = dot(hit.normal, ray.direction) > 0.0;
    hit.normal = hit.inside ? -hit.normal : hit.normal;
    return hit;
}

// What is there, as the ray meets it: from within a solid the index of refraction is the other way round.
Material surface_material(Hit hit) {
    Material material = scene_material(hit);
    material.ior = hit.inside ? 1.0 / material.ior : material.ior;
    return material;
}
