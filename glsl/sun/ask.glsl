// The functions by which a path gets the light of the sun's disk. Each method defines them in a file of this folder: off, sampled,
// chance.
#include "scene.glsl"

// Whether the sun's light on the next ray has been counted already. If it has, the ray does not count it again:
//
//     state          who has counted the sun's light on the next ray            does the ray count it?
//     SUN_SOUGHT     the path's last hit, which has sent a ray to the sun       no
//     SUN_PICTURED   the picture, which has drawn the sun's image               no
//                    (pass/sun_image.glsl); the path has no hit yet
//     SUN_REFLECTED  one of these two, by way of a mirror sphere that the       no
//                    scene names
//     SUN_CHANCE     nobody                                                     yes
//     SUN_SHOWN      nobody; the pixel sees the sun in flat mirrors that the    yes
//                    scene names, at its true size
//     SUN_PLANES     the last hit but one, by way of a flat mirror that the     no
//                    scene names; SUN_PLANES + 1: by way of two; and so on
const int SUN_SOUGHT = 0;
const int SUN_PICTURED = 1;
const int SUN_REFLECTED = 2;
const int SUN_CHANCE = 3;
const int SUN_SHOWN = 4;
const int SUN_PLANES = 5;

struct SunState {
    // One of the constants above.
    int found;
    // Whether the path has hit a surface that scatters light widely.
    bool scattered;
    // The share of the sunlight on the next ray that is left to chance: a path finds it only if it happens to take one of the few
    // directions toward the sun. Surfaces that throw light in narrow lobes or single directions, as glossy ones, mirrors and glass
    // do, leave light to chance.
    float chance;
    // The kind of the material that throws this light.
    int thrower;
    // The density, 1/sr, with which a path that finds this light takes the sun's direction: high if the light is narrow.
    float peak;
    // How likely light tracing is to take the path so far the other way round, in units of how likely the path is (sun/share.glsl). It is 0
    // if light tracing cannot take it.
    float traced;
};

// Whether the disk is there. It is a constant, so that the functions below cost nothing where it is not.
bool sun_shines();

SunState sun_start() {
    return SunState(SUN_PICTURED, false, 0.0, 0, 0.0, 0.0);
}

// The radiance that `hit` reflects directly from the sun back along `incoming`, including light that comes by way of at most
// `mirrors` mirrors.
vec3 sun_reflected(SunState state, Hit hit, Material material, vec3 incoming, int mirrors, INOUT(Sequence) sequence);

// The state after a bounce.
SunState sun_after_bounce(SunState state, Hit hit, Material material, vec3 incoming, Bounce bounce);

// The radiance of the disk to a ray that leaves the scene.
vec3 sun_escaped(SunState state, vec3 direction);

// The share of the disk's light that a path counts which leaves the scene along `ray` (sun/share.glsl). `traced` is the product of the state's members
// traced and peak.
float sun_share(float traced, Ray ray);

// Counts a path that has left the scene, if its sunlight was left to chance. `worth` is its throughput times its share of the light, and `brought` the
// light of the disk that it brings.
void sun_count(SunState state, vec3 worth, vec3 direction, vec3 brought);
