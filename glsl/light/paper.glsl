// --light paper: the bounce of the paper's author. Its lobe is 2 cos^3 / pi and not Lambert's, so that pictures converge to a result
// of their own.
#include "light/bounce_material.glsl"
#include "light/path.glsl"
#include "math/sphere_sample.glsl"

// Toward the normal's tip plus a uniform point in the unit ball: density 2 cos^3 / pi, mean cosine 0.8.
vec3 matte_direction(vec3 normal, vec2 u, vec2 v) {
    float radius = 0.999999 * pow(v.x, 1.0 / 3.0);
    return normalize(normal + radius * sphere_sample(u));
}

float matte_density(float cosine) {
    float c = max(cosine, 0.0);
    return 2.0 * c * c * c / PI;
}
