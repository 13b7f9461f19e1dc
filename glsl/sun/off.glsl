// The sun lights the sky and is not there itself.
#include "sun/ask.glsl"

vec3 sun_reflected(Hit hit, Material material, vec3 incoming, int mirrors, INOUT(Sequence) sequence) {
    return vec3(0.0);
}

int sun_after_bounce(int state, Hit hit, Material material, vec3 incoming, Bounce bounce) {
    return state;
}

vec3 sun_escaped(int state, vec3 direction) {
    return vec3(0.0);
}
