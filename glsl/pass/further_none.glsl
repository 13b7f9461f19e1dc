// There is no further light, because the air has one order and the ground is black.
#include "math/dialect.glsl"

vec3 further_light(vec3 direction) {
    return vec3(0.0);
}
