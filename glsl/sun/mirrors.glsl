// The sun by way of the mirror spheres that the scene names (`mirror-sphere`): the light that they throw on other surfaces.
//
// A name is a hint, and wrong ones do no harm: the ray toward the reflection point must find a mirror there, on that sphere.
// What is found this way and what mirrors_know() claims are the same light, so that it is counted once.
#include "light/through.glsl"
#include "material/mirror.glsl"
#include "sun/mirror_sphere.glsl"
#include <mirror-spheres>

// Which of the spheres a hit lies on, the first of several; -1 for none.
int mirror_sphere_at(Hit hit) {
    int at = -1;
    for (int i = MIRROR_SPHERES - 1; i >= 0; i--) {
        vec4 sphere = mirror_sphere(i);
        vec3 off = hit.position - vec3(sphere);
        vec3 size = abs(hit.position);
        float near = 1.0e-4 * sphere.w + 4.0e-6 * (max(max(size.x, size.y), size.z) + hit.t);
        if (abs(length(off) - sphere.w) < near) at = i;
    }
    return at;
}

// Whether the light that came this way from the sun by one reflection is what mirrors_reflect() seeks.
bool mirrors_know(Hit hit, Material material, vec3 incoming) {
    int i = mirror_sphere_at(hit);
    return i >= 0 && material.kind == MATERIAL_MIRROR && dot(hit.position - vec3(mirror_sphere(i)), incoming) < 0.0;
}

// Light from `toward` to `at`, in the world.
SphereReflection mirror_reflection(int i, vec3 at, vec3 toward) {
    vec4 sphere = mirror_sphere(i);
    return sphere_reflection((at - vec3(sphere)) / sphere.w, toward);
}

// What of that light comes to a ray toward the reflection point: the mirror's tint, or 0 where something is in the way.
vec3 mirror_tint(int i, Ray ray, vec3 toward) {
    Hit seen = surface_hit(ray);
    vec3 tint = vec3(0.0);
    if (seen.t < INFINITY && mirror_sphere_at(seen) == i) {
        Material material = scene_material(seen);
        vec3 through = light_through(ray, seen.t) * light_arriving(ray_from(seen, toward));
        tint = material.kind == MATERIAL_MIRROR ? material.color * through : vec3(0.0);
    }
    return tint;
}

// How much of a sphere's light to expect, for the choice among several.
float mirror_share(int i, vec3 at) {
    vec4 sphere = mirror_sphere(i);
    vec3 off = at - vec3(sphere);
    return sphere.w * sphere.w / max(dot(off, off), sphere.w * sphere.w);
}

// One sphere, drawn in proportion to its share of the sky, stands for all.
vec3 mirrors_reflect(Hit hit, Material material, vec3 incoming, vec3 toward, vec3 irradiance, INOUT(Sequence) sequence) {
    int chosen = 0;
    float share = 1.0;
    if (MIRROR_SPHERES > 1) {
        float total = 0.0;
        float wanted = sequence_pair(sequence).x;
        for (int i = 0; i < MIRROR_SPHERES; i++) total += mirror_share(i, hit.position);
        float passed = 0.0;
        for (int i = 0; i < MIRROR_SPHERES; i++) {
            float part = mirror_share(i, hit.position) / total;
            bool here = wanted >= passed;
            chosen = here ? i : chosen;
            share = here ? part : share;
            passed += part;
        }
    }
    SphereReflection reflection = mirror_reflection(chosen, hit.position, toward);
    vec3 value = material_value(material, hit.normal, incoming, -reflection.direction);
    vec3 reflected = reflection.focus / share * value * irradiance;
    if (max(reflected.x, max(reflected.y, reflected.z)) > 0.0) {
        reflected *= mirror_tint(chosen, ray_from(hit, -reflection.direction), toward);
    }
    return reflected;
}
