//@ title   Crater
//@ look    "the bowl's shade and the checker in the mirror ball; the sky's colours on the ground as the sun sets"
//@ camera  eye 0 2 -4  target 0 0 0  fov 90
//@ sun     elevation 30  azimuth 0
//@ size    512 512
//@ bound   0 hover 0 1
//@ mirror-sphere  0 hover 0 1
//@ preset  noon           sun.elevation 60
//@ preset  afternoon      sun.elevation 30
//@ preset  sunset         sun.elevation 5   exposure 0.5
//@ preset  early-evening  sun.elevation -2  exposure 4
//@ preset  twilight       sun.elevation -2  exposure 4

// The paper's scene: a checkered plane with a crater, and a mirror ball that floats in it. The author's floor is white and black. The albedos
// here are such that other renderers can draw the same picture.
#include "color/checker.glsl"
#include "material/matte.glsl"
#include "material/mirror.glsl"
#include "shape/plane_minus_sphere.glsl"
#include "shape/sphere.glsl"

uniform bool ball;          //@ checkbox on  label "mirror ball"
uniform float hover;        //@ slider 0.5  min -0.5  max 3  unit m  label "height of the ball's centre"
uniform float even_albedo;  //@ slider 0.8  label "albedo of the light squares"
uniform float odd_albedo;   //@ slider 0.1  label "albedo of the dark squares"

const int GROUND = 0;
const int BALL = 1;

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane_minus_sphere(ray, vec3(0.0, 1.0, 0.0), 0.0, vec3(0.0), 2.0, GROUND, hit);
    if (ball) hit_sphere(ray, vec3(0.0, hover, 0.0), 1.0, BALL, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == BALL) return mirror(vec3(1.0));
    return matte(checker(hit.position, vec3(even_albedo), vec3(odd_albedo)));
}
