// The sun lights the sky, and its disk is left out.
#include "sun/ask.glsl"
#include "sun/share_whole.glsl"

bool sun_shines() {
    return false;
}

vec3 sun_reflected(SunState state, Hit hit, Material material, vec3 incoming, int mirrors, INOUT(Sequence) sequence) {
    return vec3(0.0);
}

SunState sun_after_bounce(SunState state, Hit hit, Material material, vec3 incoming, Bounce bounce) {
    return state;
}

vec3 sun_escaped(SunState state, vec3 direction) {
    return vec3(0.0);
}

void sun_count(SunState state, vec3 worth, vec3 direction, vec3 brought) {
}
