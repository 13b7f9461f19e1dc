#include "math/dialect.glsl"

// Squares of one metre in the xz plane. The result is `even` where floor(x) + floor(z) is even, and `odd` elsewhere.
vec3 checker(vec3 position, vec3 even, vec3 odd) {
    float parity = fract(0.5 * (floor(position.x) + floor(position.z)));
    return parity < 0.25 ? even : odd;
}
