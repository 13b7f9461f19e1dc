// How mist turns light: the phase function of Henyey and Greenstein 1941. Directions are those of a path that comes from the eye.
#include "math/frame.glsl"

// The density of mist_turn(), 1/sr. The denominator 1 + g^2 - 2 g cos is written so that it keeps its digits in the peak.
float henyey_pdf(float g, vec3 incoming, vec3 outgoing) {
    float magnitude = abs(g);
    vec3 apart = incoming - outgoing;
    vec3 together = incoming + outgoing;
    vec3 from_peak = g < 0.0 ? together : apart;
    float denominator = (1.0 - magnitude) * (1.0 - magnitude) + magnitude * dot(from_peak, from_peak);
    return (1.0 - g) * (1.0 + g) / (4.0 * PI * denominator * sqrt(denominator));
}

// A direction of that density, from u in [0, 1)^2. The usual form, cos = (1 + g^2 - ((1 - g^2) / (1 - g + 2 g u))^2) / (2 g), is factored into 1 + cos and
// 1 - cos. Nothing is then divided by g, and neither peak loses digits.
vec3 henyey_sample(float g, vec3 incoming, vec2 u) {
    float magnitude = abs(g);
    float denominator = 1.0 - magnitude + 2.0 * magnitude * u.x;
    float scale = 1.0 / (denominator * denominator);
    float one_more = (1.0 + magnitude) * (1.0 + magnitude) * scale * u.x * (denominator + 1.0 - magnitude);
    float one_less = (1.0 - magnitude) * (1.0 - magnitude) * scale * (1.0 - u.x) * (denominator + 1.0 + magnitude);
    float from_more = one_more - 1.0;
    float from_less = 1.0 - one_less;
    float cosine = one_more < one_less ? from_more : from_less;
    float sine = sqrt(max(one_more * one_less, 0.0));
    float phi = 2.0 * PI * u.y;
    vec3 opposite = -incoming;
    vec3 axis = g < 0.0 ? opposite : incoming;
    return normalize(in_frame(axis, sine * cos(phi), sine * sin(phi), cosine));
}
