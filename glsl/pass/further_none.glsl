// The sky has one order and its ground is black.
#include "math/dialect.glsl"

vec3 further_light(vec3 direction) {
    return vec3(0.0);
}
