// The sunlight that mirror spheres reflect onto other surfaces, for the spheres that the scene names (`mirror-sphere`).
//
// A name is a hint, and a wrong one does no harm: the ray toward the reflection point must hit a mirror on that sphere.
// mirrors_know() is true for exactly the light that mirrors_reflect() adds, so that it is counted once.
#include "light/through.glsl"
#include "material/mirror.glsl"
#include "sun/mirror_sphere.glsl"
#include <mirror-spheres>

// The number of the sphere on which a hit lies, the first if there are several; -1 if there is none.
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

// Whether mirrors_reflect() adds the light that comes from the sun by this one reflection.
bool mirrors_know(Hit hit, Material material, vec3 incoming) {
    int i = mirror_sphere_at(hit);
    return i >= 0 && material.kind == MATERIAL_MIRROR && dot(hit.position - vec3(mirror_sphere(i)), incoming) < 0.0;
}

// The reflection of light from the direction `toward` to the point `at`, in world coordinates.
SphereReflection mirror_reflection(int i, vec3 at, vec3 toward) {
    vec4 sphere = mirror_sphere(i);
    return sphere_reflection((at - vec3(sphere)) / sphere.w, toward);
}

// The share of that light that reaches the point along a ray to the reflection point: the mirror's tint, or 0 if something is in
// the way.
vec3 mirror_tint(int i, Ray ray, vec3 toward) {
    Hit seen = surface_hit(ray);
    vec3 tint = vec3(0.0);
    if (seen.t < INFINITY && mirror_sphere_at(seen) == i) {
        Material material = surface_material(seen);
        vec3 through = light_through(ray, seen.t) * light_arriving(ray_from(seen, toward));
        tint = material.kind == MATERIAL_MIRROR ? material.color * through : vec3(0.0);
    }
    return tint;
}

// The light to expect from a sphere, relative to the others, for the choice of one.
float mirror_share(int i, vec3 at) {
    vec4 sphere = mirror_sphere(i);
    vec3 off = at - vec3(sphere);
    return sphere.w * sphere.w / max(dot(off, off), sphere.w * sphere.w);
}

// One sphere stands for all. It is chosen with a probability in proportion to mirror_share().
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
