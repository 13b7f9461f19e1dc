#include "math/dialect.glsl"

// Lines of `width` metres along the edges of one metre squares in the xz plane.
vec3 grid(vec3 position, float width, vec3 line, vec3 between) {
    vec2 off = abs(fract(vec2(position.x, position.z) + 0.5) - 0.5); // from the nearest edges
    return min(off.x, off.y) < 0.5 * width ? line : between;
}
