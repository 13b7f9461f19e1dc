// What a table of a coloured sky holds: fourth roots with their sign. A colour that no screen can show has a component below 0.
#include "math/dialect.glsl"

vec3 fourth_root(vec3 v) {
    return sign(v) * sqrt(sqrt(abs(v)));
}

vec3 fourth_power(vec3 v) {
    vec3 squared = v * v;
    return sign(v) * squared * squared;
}
