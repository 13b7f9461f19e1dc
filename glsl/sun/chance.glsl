// --sun-disk chance: only the bounces find the disk. This is right for any scene and hopelessly noisy for a disk of the sun's size.
// With a larger disk it is the reference for `sampled`.
#include "sun/ask.glsl"
#include "sun/disk.glsl"

vec3 sun_reflected(Hit hit, Material material, vec3 incoming, int mirrors, INOUT(Sequence) sequence) {
    return vec3(0.0);
}

SunState sun_after_bounce(SunState state, Hit hit, Material material, vec3 incoming, Bounce bounce) {
    return SunState(SUN_CHANCE, true, 1.0, 0);
}

vec3 sun_escaped(SunState state, vec3 direction) {
    return sun_radiance(direction);
}

void sun_count(SunState state, vec3 throughput, vec3 direction, vec3 disk) {
}
