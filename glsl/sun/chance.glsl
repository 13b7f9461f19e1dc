// --sun-disk chance: only the bounces find the disk. This is right for any scene and hopelessly noisy for a disk of the sun's size.
// With a larger disk it is the reference for `sampled`.
#include "sun/ask.glsl"
#include "sun/disk.glsl"
#include "sun/near.glsl"
#include "sun/share_whole.glsl"

bool sun_shines() {
    return true;
}

vec3 sun_reflected(SunState state, Hit hit, Material material, vec3 incoming, int mirrors, INOUT(Sequence) sequence) {
    return vec3(0.0);
}

SunState sun_after_bounce(SunState state, Hit hit, Material material, vec3 incoming, Bounce bounce) {
    bool scattered = state.scattered || bounce.pdf > 0.0;
    return SunState(SUN_CHANCE, scattered, 1.0, material.kind, 1.0 / sun_solid_angle(), 0.0);
}

vec3 sun_escaped(SunState state, vec3 direction) {
    return state.found == SUN_SOUGHT ? vec3(0.0) : sun_radiance(direction);
}
