// Phase functions, per steradian. `view` points away from the eye, and `sun` points toward the sun. Both have unit length.
#include "math/dialect.glsl"

float rayleigh_phase(vec3 view, vec3 sun) {
    float nu = dot(view, sun);
    return 3.0 / (16.0 * PI) * (1.0 + nu * nu);
}

// The phase function of Cornette and Shanks 1992. The denominator 1 + g^2 - 2 g nu is written as (1-g)^2 + g |view - sun|^2, which keeps its digits
// in the forward peak. If g is negative, the peak is in the opposite direction, and the formula is mirrored.
float mie_phase(float g, vec3 view, vec3 sun) {
    float nu = dot(view, sun);
    float magnitude = abs(g);
    vec3 apart = view - sun;
    vec3 together = view + sun;
    vec3 from_peak = g < 0.0 ? together : apart;
    float denominator = (1.0 - magnitude) * (1.0 - magnitude) + magnitude * dot(from_peak, from_peak);
    float scale = 3.0 / (8.0 * PI) * (1.0 - g) * (1.0 + g) / (2.0 + g * g);
    return scale * (1.0 + nu * nu) / (denominator * sqrt(denominator));
}
