// Bounces as the material draws them or toward the bright sky, weighed by the density of the two together: multiple importance
// sampling of one sample, by the balance heuristic (Veach 1997).
#include "light/surface.glsl"

vec3 sky_sample(vec2 u);
float sky_pdf(vec3 direction);

// Of the bounces. Those of later hits are the material's own: less light comes by way of them, and weights of up to 2 at each hit
// would multiply.
const float SKY_SHARE = 0.5;
const int SKY_HITS = 3;

float path_pdf(int hits, Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    float share = hits < SKY_HITS ? SKY_SHARE : 0.0;
    return share * sky_pdf(outgoing) + (1.0 - share) * material_pdf(material, normal, incoming, outgoing);
}

// u.x, stretched, serves again: numbers that are spread evenly stay so in each of the two halves.
Bounce path_bounce(int hits, Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    float share = hits < SKY_HITS ? SKY_SHARE : 0.0;
    bool sky = u.x < share;
    vec2 rest = vec2(sky ? u.x / SKY_SHARE : (u.x - share) / (1.0 - share), u.y);
    Bounce bounce = material_sample(material, normal, incoming, rest, v);
    if (bounce.pdf > 0.0) {
        if (sky) bounce.direction = sky_sample(rest);
        bounce.pdf = path_pdf(hits, material, normal, incoming, bounce.direction);
        bounce.weight = material_value(material, normal, incoming, bounce.direction) / max(bounce.pdf, 1.0e-20);
        bounce.lambert = false;
    }
    return bounce;
}
