// How mist turns light: the phase function of Henyey and Greenstein 1941. Directions are those of a path that comes from the eye.
#include "math/frame.glsl"

// The density of mist_turn(), 1/sr. The denominator 1 + g^2 - 2 g cos is written so that it keeps its digits in the peak.
float henyey_pdf(float g, vec3 incoming, vec3 outgoing) {
    float magnitude = abs(g);
    vec3 from_peak = g < 0.0 ? incoming + outgoing : incoming - outgoing;
    float denominator = (1.0 - magnitude) * (1.0 - magnitude) + magnitude * dot(from_peak, from_peak);
    return (1.0 - g) * (1.0 + g) / (4.0 * PI * denominator * sqrt(denominator));
}

// A direction of that density, from u in [0, 1)^2. The usual form, (1 + g^2 - ((1 - g^2) / (1 + g w))^2) / (2 g), is multiplied out, so that nothing is divided by g.
vec3 henyey_sample(float g, vec3 incoming, vec2 u) {
    float w = 2.0 * u.x - 1.0;
    float numerator = w + g * (0.5 * (3.0 + w * w) + g * (w + 0.5 * g * (w * w - 1.0)));
    float cosine = clamp(numerator / ((1.0 + g * w) * (1.0 + g * w)), -1.0, 1.0);
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    float phi = 2.0 * PI * u.y;
    return normalize(in_frame(incoming, sine * cos(phi), sine * sin(phi), cosine));
}
