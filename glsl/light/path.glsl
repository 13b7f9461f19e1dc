// The path loop, the same for every light method. A ray bounces from hit to hit, and the light of the sun's disk and of lamps is
// gathered at each. A hit is on a surface or in the mist. A method includes this file after its PathMemory and the functions that
// light/walk.glsl lists.
//
// The sun's light through mist is gathered by expectation: from each part of the path, that of one place in the mist before the surface, and that of the
// surface itself, each with its share. Where the path itself is scattered is drawn apart from this. A place in the mist where that happens does not look
// for the sun again.
#include "emission/ask.glsl"
#include "light/roulette.glsl"
#include "light/stretch.glsl"
#include "light/walk.glsl"
#include "sun/ask.glsl"

// Radiance that comes back along `ray`, with at most `max_hits` surface hits.
vec3 path_radiance(Ray ray, int max_hits, INOUT(Sequence) sequence) {
    Path path = Path(ray, vec3(1.0), vec3(0.0), 0, sun_start(), 1.0, vec3(1.0), false, 0.0, -1);
    PathMemory memory = path_start();
    // Drawn while the path is alive and used in the next turn: llvmpipe may compute what stands at a loop's top once more for paths that have ended.
    vec2 w = mist_here() ? sequence_pair(sequence) : vec2(0.0);
    mist_begin(w);
    bool alive = true;
    do {
        ray_spread = path.spread;
        ray_leaves = path.leaves;
        Stretch stretch = stretch_of(path, w);
        ray_spread = 0.0;
        ray_leaves = -1;
        Hit hit = stretch.hit;
        path.escaped = hit.t >= INFINITY;
        path.weight = stretch.weight;
        if (!stretch.in_mist) path.gathered += path.throughput * path.weight * emission_met(hit, path.ray.direction, path.lamp_share);
        if (mist_here() && path.hits < max_hits) {
            path.gathered += path.throughput * stretch_sun(stretch, path, max_hits - path.hits - 1, sequence);
        }
        alive = !path.escaped && path.hits < max_hits;
        if (alive) {
            vec3 incoming = path.ray.direction;
            vec2 u = sequence_pair(sequence);
            vec2 v = sequence_pair(sequence);
            Material material = stretch_material(stretch);
            // The sun's light is gathered by expectation, so that the choice between mist and surface has no part in it.
            vec3 before = path.throughput;
            path.throughput *= path.weight;
            Bounce bounce = path_bounce(memory, path, hit, material, u, v);
            if (mist_knows_sky() && stretch.in_mist) path.gathered += path.throughput * stretch_sky(stretch, material, incoming, bounce);
            if (sun_shines()) {
                path.gathered += before * stretch_surface_sun(stretch, path, material, max_hits - path.hits - 1, sequence);
                path.sun = sun_after_bounce(path.sun, hit, material, incoming, bounce);
            }
            // The sunlight that air scatters is gathered with any of the sun's methods.
            if (mist_is_air() && stretch.in_mist) path.sun.found = SUN_SOUGHT;
            if (emission_sought()) {
                vec3 lamp = emission_direction(hit, sequence);
                float lamp_pdf = path_pdf(memory, path, hit, material, lamp);
                path.gathered += path.throughput * emission_reflected(hit, material, incoming, lamp, lamp_pdf);
            }
            path.lamp_share = emission_share(hit, bounce);
            path.throughput *= bounce.weight;
            path.ray = ray_from(hit, bounce.direction);
            path.spread = path_spread(path.spread, bounce.pdf);
            bool outer = !hit.inside && !stretch.in_mist && dot(bounce.direction, hit.normal) > 0.0;
            path.leaves = outer ? hit.object : -1;
            path.hits += 1;
            float survival = roulette_survival(path.throughput, path.hits);
            alive = !(v.y >= survival);
            // A path that has ended brings nothing, whatever is computed of it after this turn.
            vec3 survivor = path.throughput / survival;
            path.throughput = alive ? survivor : vec3(0.0);
            if (mist_here()) w = sequence_pair(sequence);
            mist_begin(w);
            path_after(memory, path, alive);
        }
    } while (alive);
    if (path.escaped) path.throughput *= path.weight;
    vec3 disk = vec3(0.0);
    if (sun_shines()) {
        float share = sun_share(path.sun.traced * path.sun.peak, path.ray);
        disk = share * sun_escaped(path.sun, path.ray.direction);
        if (path.escaped) sun_count(path.sun, share * path.throughput, path.ray.direction, path.throughput * disk);
    }
    return path_finish(memory, path, disk);
}
