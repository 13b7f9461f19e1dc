#include "math/dialect.glsl"

// Draws a point on the unit sphere that is uniform by area. u is in [0,1)^2.
vec3 sphere_sample(vec2 u) {
    float z = 1.0 - 2.0 * u.x;
    float r = 2.0 * sqrt(max(u.x * (1.0 - u.x), 0.0));
    float phi = 2.0 * PI * u.y;
    return vec3(r * cos(phi), r * sin(phi), z);
}
