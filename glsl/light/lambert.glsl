#include "math/sphere_sample.glsl"

// Lambert's matte surface: density cos / pi over the hemisphere, by a uniform point on the unit sphere that touches the surface
// from above. The sphere is shrunk by a rounding or two, so that the point opposite to the normal still has a direction.
vec3 matte_direction(vec3 normal, vec2 u, vec2 v) {
    return normalize(normal + 0.999999 * sphere_sample(u));
}

float matte_density(float cosine) {
    return max(cosine, 0.0) / PI;
}
