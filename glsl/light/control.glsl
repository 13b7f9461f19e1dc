// --light control: the cosine's bounces, and on level ground the unblocked sky as a control variate.
//
// How much light level ground reflects from a sky that nothing blocks is known from the ground's normal alone (irradiance.glsl). At
// the first hit on level ground the path counts that known light. In exchange, the bounce from there brings its light L less the
// sky's radiance behind it: nothing if the bounce escapes; the blocker's light less the light of the sky that it hides if it does not.
// The mean stays the same, and the noise of the open sky is gone. Some of these bounces go toward the scene's bounds, where the sky
// may be blocked. On slopes and in hollows much of the sky is blocked, and the plain cosine does better there.
#include "light/irradiance.glsl"
#include "light/lambert.glsl"
#include "light/walk.glsl"
#include "math/cone.glsl"
#include "math/finite.glsl"

vec3 sky_irradiance_over_pi(vec3 normal);

// The share of the bounces from level ground that go toward a bound: it grows as the square root of the share of the ground's light
// that the bound may block, up to a limit. The limit leaves bounces for blockers that lie in no bound. Pairs of values from (0.8, 0.5)
// to (12, 0.9) were tried; this pair took the fewest samples over crater, fences and mirrors.
const float BLOCKER_SHARE = 3.0;
const float BLOCKER_SHARE_MOST = 0.4; // all bounds together

float blocker_share(Cone cone, vec3 normal) {
    float sine_squared = cone.one_less_cos * (2.0 - cone.one_less_cos);
    float blocked = sine_squared * clamp(dot(cone.axis, normal), 0.1, 1.0);
    return min(BLOCKER_SHARE * sqrt(blocked), BLOCKER_SHARE_MOST / float(max(SCENE_BOUNDS, 1)));
}

Cone blocker_cone(int i, vec3 position) {
    vec4 bound = scene_bound(i);
    // Empty for a position inside of the bound.
    return cone_toward(position, vec3(bound), bound.w);
}

// What a bounce from level ground is drawn with: the cosine, or the cone of one of the bounds.
struct BlockerChoice {
    bool cosine;
    // For drawing the direction. u.x made the choice, and is stretched to [0, 1) again: evenly spread numbers stay evenly spread in
    // each part.
    vec2 u;
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

// The density of the cosine and the cones together, 1/sr.
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

// Takes a bounce that was drawn by Lambert's cosine, and turns it toward the chosen bound if there is one. The weight is 0 for a
// direction into the ground.
Bounce blocker_bounce(Bounce bounce, vec3 position, vec3 normal, BlockerChoice choice) {
    if (!choice.cosine) bounce.direction = cone_sample(choice.cone, choice.u);
    bounce.pdf = blocker_pdf(position, normal, bounce.direction);
    float weight = matte_density(dot(bounce.direction, normal)) / bounce.pdf;
    bounce.weight *= bounce.pdf > 0.0 ? weight : 0.0;
    return bounce;
}

// What the path remembers about its first hit on level ground. Looking the sky up is left to path_finish().
struct PathMemory {
    // Whether there was one. The crater takes 8 % longer where `hit` alone tells.
    bool controlled;
    // The number of that hit, counted from 1.
    int hit;
    vec3 normal;
    // The known light there, over the open sky's irradiance.
    vec3 known;
    // What the bounce from there takes off, over the sky's radiance in its direction.
    vec3 control;
    vec3 direction;
};

PathMemory path_start() {
    vec3 up = vec3(0.0, 1.0, 0.0);
    return PathMemory(false, 0, up, vec3(0.0), vec3(0.0), up);
}

Bounce path_bounce(INOUT(PathMemory) memory, Path path, Hit hit, Material material, vec2 u, vec2 v) {
    bool level = hit.normal.y >= LEVEL_GROUND && !memory.controlled;
    BlockerChoice choice = blocker_choice(hit.position, hit.normal, u);
    Bounce bounce = material_sample(material, hit.normal, path.ray.direction, level ? choice.u : u, v);
    if (level && bounce.lambert) {
        memory.controlled = true;
        memory.hit = path.hits + 1;
        memory.normal = hit.normal;
        memory.known = path.throughput * bounce.weight;
        bounce = blocker_bounce(bounce, hit.position, hit.normal, choice);
        memory.direction = bounce.direction;
    }
    return bounce;
}

float path_pdf(PathMemory memory, Path path, Hit hit, Material material, vec3 direction) {
    bool level = memory.hit == path.hits + 1;
    return level ? blocker_pdf(hit.position, hit.normal, direction)
                 : material_pdf(material, hit.normal, path.ray.direction, direction);
}

void path_after(INOUT(PathMemory) memory, Path path, bool alive) {
    if (memory.hit == path.hits) memory.control = alive ? path.throughput : vec3(0.0);
}

// If the bounce from the level ground escapes at once, what it brings and what it takes off are the same, and the known light is all.
vec3 path_finish(PathMemory memory, Path path, vec3 disk) {
    bool open = path.escaped && memory.controlled && path.hits == memory.hit && path.weight == vec3(1.0);
    vec3 known = memory.known * sky_irradiance_over_pi(memory.normal);
    vec3 brought = path.throughput * sky_radiance(path.ray.direction);
    vec3 taken = memory.control * sky_radiance(memory.direction);
    vec3 sky = known;
    if (path.escaped || !is_finite(brought)) sky += brought;
    if (memory.controlled) sky -= taken;
    vec3 sun = path.escaped ? path.throughput * disk : vec3(0.0);
    return path.gathered + (open ? known : sky) + sun;
}

#include "light/path.glsl"
