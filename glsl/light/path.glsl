// The path loop, the same for every light method. A ray bounces from hit to hit, and the light of the sun's disk and of lamps is
// gathered at each. There is no air between the hits. A method includes this file after its PathMemory and the functions that
// light/walk.glsl lists.
#include "emission/ask.glsl"
#include "light/roulette.glsl"
#include "light/walk.glsl"
#include "sun/ask.glsl"

// Radiance that comes back along `ray`, with at most `max_hits` surface hits.
vec3 path_radiance(Ray ray, int max_hits, INOUT(Sequence) sequence) {
    Path path = Path(ray, vec3(1.0), vec3(0.0), 0, sun_start(), 1.0, false);
    PathMemory memory = path_start();
    bool alive = true;
    do {
        Hit hit = surface_hit(path.ray);
        path.escaped = hit.t >= INFINITY;
        path.gathered += path.throughput * emission_met(hit, path.ray.direction, path.lamp_share);
        alive = !path.escaped && path.hits < max_hits;
        if (alive) {
            vec3 incoming = path.ray.direction;
            vec2 u = sequence_pair(sequence);
            vec2 v = sequence_pair(sequence);
            Material material = surface_material(hit);
            Bounce bounce = path_bounce(memory, path, hit, material, u, v);
            path.gathered += path.throughput * sun_reflected(path.sun, hit, material, incoming, max_hits - path.hits - 1, sequence);
            path.sun = sun_after_bounce(path.sun, hit, material, incoming, bounce);
            vec3 lamp = emission_direction(hit, sequence);
            float lamp_pdf = path_pdf(memory, path, hit, material, lamp);
            path.gathered += path.throughput * emission_reflected(hit, material, incoming, lamp, lamp_pdf);
            path.lamp_share = emission_share(hit, bounce);
            path.throughput *= bounce.weight;
            path.ray = ray_from(hit, bounce.direction);
            path.hits += 1;
            float survival = roulette_survival(path.throughput, path.hits);
            alive = !(v.y >= survival);
            path.throughput /= alive ? survival : 1.0;
            path_after(memory, path, alive);
        }
    } while (alive);
    float share = sun_share(path.sun.traced * path.sun.peak, path.ray);
    vec3 disk = share * sun_escaped(path.sun, path.ray.direction);
    if (path.escaped) sun_count(path.sun, share * path.throughput, path.ray.direction, path.throughput * disk);
    return path_finish(memory, path, disk);
}
