#include "math/dialect.glsl"

// Lines that are `width` metres wide, along the edges of squares of one metre in the xz plane.
vec3 grid(vec3 position, float width, vec3 line, vec3 between) {
    // The distances from the nearest edges.
    vec2 off = abs(fract(vec2(position.x, position.z) + 0.5) - 0.5);
    return min(off.x, off.y) < 0.5 * width ? line : between;
}
