// Bounces in the directions that the material draws, or toward the bright sky. A bounce is weighed by the density of the two
// together: multiple importance sampling of one sample, by the balance heuristic (Veach 1997).
#include "light/memory_none.glsl"

vec3 sky_sample(vec2 u);
float sky_pdf(vec3 direction);

// The share of the bounces that go toward the sky, at the first SKY_HITS hits. Later bounces are the material's own: they bring less
// light, and the weights of up to 2 at each hit would multiply.
const float SKY_SHARE = 0.5;
const int SKY_HITS = 3;

float path_pdf(PathMemory memory, Path path, Hit hit, Material material, vec3 direction) {
    float share = path.hits < SKY_HITS ? SKY_SHARE : 0.0;
    return share * sky_pdf(direction) + (1.0 - share) * material_pdf(material, hit.normal, path.ray.direction, direction);
}

// u.x chooses one of the two, and is stretched to [0, 1) again for its second use: evenly spread numbers stay evenly spread in each
// part.
Bounce path_bounce(INOUT(PathMemory) memory, Path path, Hit hit, Material material, vec2 u, vec2 v) {
    float share = path.hits < SKY_HITS ? SKY_SHARE : 0.0;
    vec3 incoming = path.ray.direction;
    bool sky = u.x < share;
    float below = u.x / SKY_SHARE;
    float above = (u.x - share) / (1.0 - share);
    vec2 rest = vec2(sky ? below : above, u.y);
    Bounce bounce = material_sample(material, hit.normal, incoming, rest, v);
    if (bounce.pdf > 0.0) {
        if (sky) bounce.direction = sky_sample(rest);
        bounce.pdf = path_pdf(memory, path, hit, material, bounce.direction);
        bounce.weight = material_value(material, hit.normal, incoming, bounce.direction) / max(bounce.pdf, 1.0e-20);
        bounce.lambert = false;
    }
    return bounce;
}
