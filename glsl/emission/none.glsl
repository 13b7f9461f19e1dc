// For a scene without a material that emits.
#include "emission/unsought.glsl"

vec3 emission_met(Hit hit, vec3 incoming, float share) {
    return vec3(0.0);
}
