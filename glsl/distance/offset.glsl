#include "math/dialect.glsl"

// Rounds edges and grows the solid by `radius`. Exact outside.
float op_round(float d, float radius) {
    return d - radius;
}

// The surface alone, `thickness` thick in all, half of it to each side.
float op_shell(float d, float thickness) {
    return abs(d) - 0.5 * thickness;
}
