// --light portal: bounces by the material, and a ray at each hit toward the sky behind one of the openings that the scene names
// (`portal`). The bounces may find the same light, so the two are weighed by multiple importance sampling with the balance heuristic
// (Veach 1997).
//
// A portal is a hint, and a wrong one costs time but does not change the mean: the ray counts the sky only where it leaves the scene,
// and what it cannot find is left to the bounces.
#include "light/lambert.glsl"
#include "light/through.glsl"
#include "light/walk.glsl"
#include "math/finite.glsl"
#include "math/rectangle.glsl"
#include <portals>
#include "light/openings.glsl"

struct PathMemory {
    // The sky's light that the rays have found.
    vec3 found;
    // The share of the sky's light that is left to the last bounce.
    float share;
};

PathMemory path_start() {
    return PathMemory(vec3(0.0), 1.0);
}

float path_pdf(PathMemory memory, Path path, Hit hit, Material material, vec3 direction) {
    return material_pdf(material, hit.normal, path.ray.direction, direction);
}

// What a hit reflects of the sky in a direction through a portal, without the share that is left to the bounce.
vec3 portal_reflected(Path path, Hit hit, Material material, vec3 direction, float pdf) {
    vec3 incoming = path.ray.direction;
    vec3 value = material_value(material, hit.normal, incoming, direction);
    vec3 reflected = vec3(0.0);
    if (pdf > 0.0 && max(value.x, max(value.y, value.z)) > 0.0) {
        vec3 arriving = light_arriving(ray_from(hit, direction));
        if (max(arriving.x, max(arriving.y, arriving.z)) > 0.0) {
            float bounce_pdf = material_pdf(material, hit.normal, incoming, direction);
            reflected = value * arriving * sky_radiance(direction) / (pdf + bounce_pdf);
        }
    }
    return reflected;
}

// v is for the ray, and for what a material needs beside u. The light of the ray and that of the bounce are added, so that they may share
// a number.
Bounce path_bounce(INOUT(PathMemory) memory, Path path, Hit hit, Material material, vec2 u, vec2 v) {
    Bounce bounce = material_sample(material, hit.normal, path.ray.direction, u, v);
    memory.share = 1.0;
    if (bounce.pdf > 0.0) {
        Openings openings = openings_seen(hit.position, hit.normal);
        vec3 direction = openings_sample(openings, hit.normal, v);
        float pdf = openings_pdf(openings, direction);
        memory.found += path.throughput * portal_reflected(path, hit, material, direction, pdf);
        memory.share = bounce.pdf / (bounce.pdf + openings_pdf(openings, bounce.direction));
    }
    return bounce;
}

void path_after(INOUT(PathMemory) memory, Path path, bool alive) {
}

// A path that ended in the scene brings no sky, unless the sky's value is not finite: such a sample must be seen and counted.
vec3 path_finish(PathMemory memory, Path path, vec3 disk) {
    vec3 brought = path.throughput * (memory.share * sky_radiance(path.ray.direction) + disk);
    vec3 gathered = path.gathered + memory.found;
    if (path.escaped || !is_finite(brought)) gathered += brought;
    return gathered;
}

#include "light/path.glsl"
