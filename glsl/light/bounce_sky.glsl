// Bounces as the material draws them or toward the bright sky, weighed by the density of the two together: multiple importance
// sampling of one sample, by the balance heuristic (Veach 1997).
#include "light/surface.glsl"

vec3 sky_sample(vec2 u);
float sky_pdf(vec3 direction);

const float SKY_SHARE = 0.5; // of the bounces

float path_pdf(Material material, vec3 normal, vec3 incoming, vec3 outgoing) {
    return SKY_SHARE * sky_pdf(outgoing) + (1.0 - SKY_SHARE) * material_pdf(material, normal, incoming, outgoing);
}

// u.x, stretched, serves again: numbers that are spread evenly stay so in each of the two halves.
Bounce path_bounce(Material material, vec3 normal, vec3 incoming, vec2 u, vec2 v) {
    bool sky = u.x < SKY_SHARE;
    vec2 rest = vec2(sky ? u.x / SKY_SHARE : (u.x - SKY_SHARE) / (1.0 - SKY_SHARE), u.y);
    Bounce bounce = material_sample(material, normal, incoming, rest, v);
    if (bounce.pdf > 0.0) {
        if (sky) bounce.direction = sky_sample(rest);
        bounce.pdf = path_pdf(material, normal, incoming, bounce.direction);
        bounce.weight = material_value(material, normal, incoming, bounce.direction) / max(bounce.pdf, 1.0e-20);
        bounce.lambert = false;
    }
    return bounce;
}
