// Phase functions, per steradian; `view` looks away from the eye and `sun` toward the sun, both of unit length.
#include "math/dialect.glsl"

float rayleigh_phase(vec3 view, vec3 sun) {
    float nu = dot(view, sun);
    return 3.0 / (16.0 * PI) * (1.0 + nu * nu);
}

// Cornette and Shanks 1992. The denominator 1 + g^2 - 2 g nu is (1-g)^2 + g |view - sun|^2, which keeps its digits in the
// forward peak; for g < 0 the peak is opposite and so is the form.
float mie_phase(float g, vec3 view, vec3 sun) {
    float nu = dot(view, sun);
    float magnitude = abs(g);
    vec3 from_peak = g < 0.0 ? view + sun : view - sun;
    float denominator = (1.0 - magnitude) * (1.0 - magnitude) + magnitude * dot(from_peak, from_peak);
    float scale = 3.0 / (8.0 * PI) * (1.0 - g) * (1.0 + g) / (2.0 + g * g);
    return scale * (1.0 + nu * nu) / (denominator * sqrt(denominator));
}
