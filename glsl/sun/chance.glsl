// --sun chance: the disk is found by the bounces alone. Right for any scene and hopelessly noisy for a disk of the sun's size: it is
// there to judge `sampled` by, with a larger disk.
#include "sun/ask.glsl"
#include "sun/disk.glsl"

vec3 sun_reflected(Hit hit, Material material, vec3 incoming, int mirrors, INOUT(Sequence) sequence) {
    return vec3(0.0);
}

int sun_after_bounce(int state, Hit hit, Material material, vec3 incoming, Bounce bounce) {
    return SUN_CHANCE;
}

vec3 sun_escaped(int state, vec3 direction) {
    return sun_radiance(direction);
}
