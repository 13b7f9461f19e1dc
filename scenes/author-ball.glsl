//@ title   The author's ball
//@ look    "the whole sky in a mirror ball that floats in it: the low sun's glow behind the ball, and in it what is behind you"
//@ camera  eye -4 1 -8  target 3 1.5 0  fov 90
//@ sun     elevation 2.862  azimuth 0
//@ size    512 512
//@ mirror-sphere  0 height 0 radius
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4
//@ preset  author    sun.elevation 2.862  atmosphere.rayleigh_scatter_per_m 3.8e-6,1.35e-5,3.31e-5

// The mirror ball of Simmons 2017, with his numbers. His picture is the mirror image of this one. The ball reflects what his absorbance leaves.
#include "material/mirror.glsl"
#include "shape/sphere.glsl"

uniform float height;     //@ slider 0.75  min 0  max 3  unit m  label "of the ball's centre"
uniform float radius;     //@ slider 1  min 0.1  max 3  unit m  label "of the ball"
uniform float absorbance; //@ slider 0.1  label "what the mirror takes"

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_sphere(ray, vec3(0.0, height, 0.0), radius, 0, hit);
}

Material scene_material(Hit hit) {
    return mirror(vec3(1.0 - absorbance));
}
