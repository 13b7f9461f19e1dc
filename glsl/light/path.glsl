// The path: rays bounce in the scene, without air between the hits, and whoever escapes brings the sky's radiance back.
#include "light/roulette.glsl"
#include "light/surface.glsl"
#include "math/finite.glsl"

// Radiance that comes back along `ray`, with at most `max_hits` surface hits. The sky is asked once, after the loop,
// where all of a picture's neighbours ask together.
vec3 path_radiance(Ray ray, int max_hits, INOUT(Sequence) sequence) {
    vec3 throughput = vec3(1.0);
    int hits = 0;
    bool escaped = false;
    bool alive = true;
    do {
        Hit hit = surface_hit(ray);
        escaped = hit.t >= INFINITY;
        alive = !escaped && hits < max_hits;
        if (alive) {
            vec2 u = sequence_pair(sequence);
            vec2 v = sequence_pair(sequence);
            Bounce bounce = material_sample(scene_material(hit), hit.normal, ray.direction, u, v);
            throughput *= bounce.weight;
            ray = ray_from(hit, bounce.direction);
            hits += 1;
            float survival = roulette_survival(throughput, hits);
            alive = !(v.y >= survival);
            throughput /= alive ? survival : 1.0;
        }
    } while (alive);
    // A path that ended in the scene brings nothing, but for what is not finite: that must be seen and counted.
    vec3 radiance = throughput * sky_radiance(ray.direction);
    return escaped || !is_finite(radiance) ? radiance : vec3(0.0);
}
