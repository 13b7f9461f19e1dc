// --light control: cosine, and on level ground the unblocked sky as control variate.
//
// What level ground would reflect of a sky that nothing blocks is known from its normal alone (irradiance.glsl). The bounce from
// the first such hit therefore brings, in place of the light L from its direction, L - sky: nothing where it escapes, and where it
// is blocked, the blocker's light less the sky's behind it. The mean is the same and the open sky's noise is gone. Some of these
// bounces go toward what may block the sky, where the scene says where that is (bounds). On slopes and in hollows much is blocked,
// and there the plain cosine does better.
#include "emission/ask.glsl"
#include "math/cone.glsl"
#include "light/irradiance.glsl"
#include "light/lambert.glsl"
#include "light/roulette.glsl"
#include "light/surface.glsl"
#include "math/finite.glsl"
#include "sun/ask.glsl"

vec3 sky_irradiance_over_pi(vec3 normal);

// How many of the bounces from a piece of level ground go toward a bound, by the square root of the share of the ground's light that
// the bound may block, up to a limit: what blocks and lies in no bound is left to the others. Of the shares tried, from 0.8 and 0.5 to
// 12 and 0.9, these took the fewest samples over crater, fences and mirrors.
const float BLOCKER_SHARE = 3.0;
const float BLOCKER_SHARE_MOST = 0.4; // of all bounds together

float blocker_share(Cone cone, vec3 normal) {
    float sine_squared = cone.one_less_cos * (2.0 - cone.one_less_cos);
    float blocked = sine_squared * clamp(dot(cone.axis, normal), 0.1, 1.0);
    return min(BLOCKER_SHARE * sqrt(blocked), BLOCKER_SHARE_MOST / float(max(SCENE_BOUNDS, 1)));
}

Cone blocker_cone(int i, vec3 position) {
    vec4 bound = scene_bound(i);
    return cone_toward(position, vec3(bound), bound.w); // empty from inside of the bound
}

// What a bounce from level ground is drawn with: the cosine, or the cone of one of the bounds.
struct BlockerChoice {
    bool cosine;
    vec2 u; // u.x chooses, and stretched serves again: numbers that are spread evenly stay so in each of the parts
    Cone cone;
};

BlockerChoice blocker_choice(vec3 position, vec3 normal, vec2 u) {
    BlockerChoice choice = BlockerChoice(true, u, Cone(normal, 0.0));
    float passed = 0.0;
    for (int i = 0; i < SCENE_BOUNDS; i++) {
        Cone cone = blocker_cone(i, position);
        float share = blocker_share(cone, normal);
        if (u.x >= passed && u.x < passed + share) choice = BlockerChoice(false, vec2((u.x - passed) / share, u.y), cone);
        passed += share;
    }
    if (choice.cosine) choice.u.x = (u.x - passed) / (1.0 - passed);
    return choice;
}

// The density of all parts together, 1/sr.
float blocker_pdf(vec3 position, vec3 normal, vec3 direction) {
    float density = 0.0;
    float left = 1.0;
    for (int i = 0; i < SCENE_BOUNDS; i++) {
        Cone cone = blocker_cone(i, position);
        float share = blocker_share(cone, normal);
        if (share > 0.0) density += share * cone_pdf(cone, direction);
        left -= share;
    }
    return left * matte_density(dot(direction, normal)) + density;
}

// A bounce from Lambert's ground, drawn by the cosine, or anew toward the chosen bound; its weight is 0 for a direction into the
// ground.
Bounce blocker_bounce(Bounce bounce, vec3 position, vec3 normal, BlockerChoice choice) {
    if (!choice.cosine) bounce.direction = cone_sample(choice.cone, choice.u);
    bounce.pdf = blocker_pdf(position, normal, bounce.direction);
    bounce.weight *= bounce.pdf > 0.0 ? matte_density(dot(bounce.direction, normal)) / bounce.pdf : 0.0;
    return bounce;
}

vec3 path_radiance(Ray ray, int max_hits, INOUT(Sequence) sequence) {
    vec3 throughput = vec3(1.0);
    vec3 gathered = vec3(0.0); // at the hits so far
    int sun = SUN_PICTURED;
    float share = 1.0; // of the light that the next hit emits
    // What is looked up about the first level ground is looked up after the loop, once for all neighbours.
    vec3 known = vec3(0.0);   // the open sky's light on it, over the irradiance
    vec3 known_normal = vec3(0.0, 1.0, 0.0);
    vec3 control = vec3(0.0); // what the bounce from there takes off, over the sky's radiance behind it
    vec3 control_direction = vec3(0.0, 1.0, 0.0);
    bool controlled = false;
    bool escaped = false;
    int hits = 0;
    int control_hits = 0;
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
            bool level = hit.normal.y >= LEVEL_GROUND && !controlled;
            vec3 toward = emission_direction(hit, sequence);
            BlockerChoice choice = blocker_choice(hit.position, hit.normal, u);
            Bounce bounce = material_sample(material, hit.normal, ray.direction, level ? choice.u : u, v);
            hits += 1;
            gathered += throughput * sun_reflected(hit, material, ray.direction, max_hits - hits, sequence);
            sun = sun_after_bounce(sun, hit, material, ray.direction, bounce);
            bool lambert = bounce.lambert && level;
            float rival = lambert ? blocker_pdf(hit.position, hit.normal, toward)
                                  : material_pdf(material, hit.normal, ray.direction, toward);
            gathered += throughput * emission_reflected(hit, material, ray.direction, toward, rival);
            if (lambert) {
                controlled = true;
                control_hits = hits;
                known = throughput * bounce.weight;
                known_normal = hit.normal;
                bounce = blocker_bounce(bounce, hit.position, hit.normal, choice);
                control_direction = bounce.direction;
            }
            share = emission_share(hit, bounce);
            throughput *= bounce.weight;
            ray = ray_from(hit, bounce.direction);
            float survival = roulette_survival(throughput, hits);
            alive = !(v.y >= survival);
            throughput /= alive ? survival : 1.0;
            if (hits == control_hits) control = alive ? throughput : vec3(0.0);
        }
    } while (alive);
    known *= sky_irradiance_over_pi(known_normal);
    // The bounce from the level ground that escapes at once brings what is known already.
    bool open = escaped && controlled && hits == control_hits;
    vec3 brought = throughput * sky_radiance(ray.direction);
    vec3 taken = control * sky_radiance(control_direction);
    vec3 sky = known;
    if (escaped || !is_finite(brought)) sky += brought;
    if (controlled) sky -= taken;
    vec3 disk = escaped ? throughput * sun_escaped(sun, ray.direction) : vec3(0.0);
    return gathered + (open ? known : sky) + disk;
}
