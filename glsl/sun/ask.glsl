// What a path asks about the sun's disk. The files beside this one answer: off, sampled, chance.
#include "scene.glsl"

// Who has counted the sun already, for the light that the next ray may bring from it, and whether the ray counts it:
//
//     SUN_SOUGHT     the path's last hit has sent a ray to the sun      the ray does not count it
//     SUN_PICTURED   the picture has drawn it (sun/image.glsl); the     the ray does not count it
//                    path has no hit yet
//     SUN_REFLECTED  one of these two, by way of a mirror sphere that   the ray does not count it
//                    the scene names
//     SUN_CHANCE     nobody                                             the ray counts it
//     SUN_SHOWN      nobody; the pixel sees it in flat mirrors that     the ray counts it
//                    the scene names, as large as it is
//     SUN_PLANES     the last hit but one, by way of a flat mirror      the ray does not count it
//                    that the scene names; + 1: of two; and so on
const int SUN_SOUGHT = 0;
const int SUN_PICTURED = 1;
const int SUN_REFLECTED = 2;
const int SUN_CHANCE = 3;
const int SUN_SHOWN = 4;
const int SUN_PLANES = 5;

struct SunState {
    // One of the above.
    int found;
    // Whether the path has met a surface that scatters light widely.
    bool scattered;
    // Share of the sunlight that the next ray may bring which is found by chance alone: only if one of the few directions toward the
    // sun happens to be drawn. Surfaces that throw light, as mirrors and glass do, leave light to chance.
    float chance;
    // The kind of the material that throws it.
    int thrower;
};

SunState sun_start() {
    return SunState(SUN_PICTURED, false, 0.0, 0);
}

// Radiance that `hit` reflects straight from the sun back along `incoming`, by way of at most `mirrors` mirrors.
vec3 sun_reflected(Hit hit, Material material, vec3 incoming, int mirrors, INOUT(Sequence) sequence);

// The state after a bounce.
SunState sun_after_bounce(SunState state, Hit hit, Material material, vec3 incoming, Bounce bounce);

// Radiance of the disk to a ray that leaves the scene.
vec3 sun_escaped(SunState state, vec3 direction);

// Counts a path that has left the scene, where its light from the sun was left to chance.
void sun_count(SunState state, vec3 throughput, vec3 direction);
