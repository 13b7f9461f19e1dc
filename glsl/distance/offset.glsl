#include "math/dialect.glsl"

// Grows a solid by `radius`, which rounds its edges. The distance is exact outside.
float op_round(float d, float radius) {
    return d - radius;
}

// Keeps only the surface of a solid, as a shell. Half of `thickness` is on each side of the surface.
float op_shell(float d, float thickness) {
    return abs(d) - 0.5 * thickness;
}
