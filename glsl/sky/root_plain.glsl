// What a table of the sky holds: the fourth roots of sums, which are never below 0 (sky/table.glsl).
#include "math/dialect.glsl"

vec3 fourth_root(vec3 v) {
    return sqrt(sqrt(v));
}

vec3 fourth_power(vec3 v) {
    vec3 squared = v * v;
    return squared * squared;
}
