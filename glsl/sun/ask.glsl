// What a path asks about the sun's disk. The files beside this one answer: off, sampled, chance.
#include "scene.glsl"

// Who found the sun already, for the light that the next ray may bring from it.
const int SUN_SOUGHT = 0;    // the path's last point sought it: the ray must not count it
const int SUN_PICTURED = 1;  // there is no such point yet, and the picture does (pass/sun_image.glsl)
const int SUN_REFLECTED = 2; // either, by way of one mirror sphere that the scene names
const int SUN_CHANCE = 3;    // nobody: the ray counts it if it finds it
const int SUN_PLANES = 4;    // and on: a point sought it by way of one flat mirror that the scene names, of two ...

// Radiance that `hit` reflects straight from the sun back along `incoming`, by way of at most `mirrors` mirrors.
vec3 sun_reflected(Hit hit, Material material, vec3 incoming, int mirrors, INOUT(Sequence) sequence);

// The state after a bounce.
int sun_after_bounce(int state, Hit hit, Material material, vec3 incoming, Bounce bounce);

// Radiance of the disk to a ray that leaves the scene.
vec3 sun_escaped(int state, vec3 direction);
