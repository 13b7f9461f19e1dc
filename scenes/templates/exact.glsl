//@ title   TITLE
//@ camera  eye 0 1.6 -5  target 0 0.7 0  fov 45
//@ sun     elevation 25  azimuth 60
//@ size    640 400
//@ preset  noon    sun.elevation 60
//@ preset  sunset  sun.elevation 5  exposure 0.5

// A scene to begin with. See it with `magichour view FILE`, and leave that window open: each time this file is saved, the picture changes.
// Lengths are in metres and y is up. Lines that begin with //@ are for magichour; scenes/README.md of the program lists them all.

// What is used is included, and what is not included costs nothing. glsl/README.md lists all shapes, materials and colours.
#include "color/checker.glsl"
#include "material/matte.glsl"
#include "material/mirror.glsl"
#include "shape/box.glsl"
#include "shape/plane.glsl"
#include "shape/sphere.glsl"

// A uniform with an annotation is a slider, a checkbox or a colour in the window, and a setting on the command line: --set radius=0.8
uniform float radius;  //@ slider 0.6  min 0.1  max 1.5  unit m  label "radius of the ball"
uniform bool box;      //@ checkbox on  label "a box beside the ball"
uniform vec3 paint;    //@ color 0.7 0.25 0.15  label "colour of the box"

// Each thing has a number of your own, by which its material is found.
const int GROUND = 0;
const int BALL = 1;
const int BOX = 2;

// Where a ray meets the scene: each hit_...() keeps the hit if it is nearer than those before.
void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    hit_sphere(ray, vec3(-0.4, radius, 0.0), radius, BALL, hit);
    if (box) hit_box(ray, vec3(1.1, 0.4, 0.3), vec3(0.4), BOX, hit);
}

// What is hit is made of: matte(colour), mirror(colour), and others. A colour is the share of light that is thrown back, 0 to 1.
Material scene_material(Hit hit) {
    if (hit.object == BALL) return mirror(vec3(0.9));
    if (hit.object == BOX) return matte(paint);
    return matte(checker(hit.position, vec3(0.6), vec3(0.2)));
}
