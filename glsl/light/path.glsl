// The path: rays bounce in the scene, without air between the hits, and whoever escapes brings the sky's radiance back.
#include "emission/ask.glsl"
#include "light/roulette.glsl"
#include "light/surface.glsl"
#include "sun/ask.glsl"
#include "math/finite.glsl"

// How paths go on after so many hits before this one, and the density of that, 1/sr.
Bounce path_bounce(int hits, Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v);
float path_pdf(int hits, Material material, vec3 normal, vec3 incoming, vec3 outgoing);

// Radiance that comes back along `ray`, with at most `max_hits` surface hits. The sky is asked once, after the loop,
// where all of a picture's neighbours ask together.
vec3 path_radiance(Ray ray, int max_hits, INOUT(Sequence) sequence) {
    vec3 throughput = vec3(1.0);
    vec3 gathered = vec3(0.0); // at the hits so far
    int sun = SUN_PICTURED;
    float share = 1.0; // of the light that the next hit emits
    int hits = 0;
    bool escaped = false;
    bool alive = true;
    do {
        Hit hit = surface_hit(ray);
        escaped = hit.t >= INFINITY;
        gathered += throughput * emission_met(hit, ray.direction, share);
        alive = !escaped && hits < max_hits;
        if (alive) {
            vec2 u = sequence_pair(sequence);
            vec2 v = sequence_pair(sequence);
            Material material = surface_material(hit);
            Bounce bounce = path_bounce(hits, material, hit.normal, ray.direction, u, v);
            gathered += throughput * sun_reflected(hit, material, ray.direction, max_hits - hits - 1, sequence);
            sun = sun_after_bounce(sun, hit, material, ray.direction, bounce);
            vec3 toward = emission_direction(hit, sequence);
            float rival = path_pdf(hits, material, hit.normal, ray.direction, toward);
            hits += 1;
            gathered += throughput * emission_reflected(hit, material, ray.direction, toward, rival);
            share = emission_share(hit, bounce);
            throughput *= bounce.weight;
            ray = ray_from(hit, bounce.direction);
            float survival = roulette_survival(throughput, hits);
            alive = !(v.y >= survival);
            throughput /= alive ? survival : 1.0;
        }
    } while (alive);
    // A path that ended in the scene brings no sky, but for what is not finite: that must be seen and counted.
    vec3 brought = throughput * (sky_radiance(ray.direction) + sun_escaped(sun, ray.direction));
    return escaped || !is_finite(brought) ? gathered + brought : gathered;
}
