//@ title   TITLE
//@ camera  eye 0 1.8 -4.5  target 0 0.8 0  fov 45
//@ sun     elevation 25  azimuth 60
//@ size    640 400
//@ preset  noon    sun.elevation 60
//@ preset  sunset  sun.elevation 5  exposure 0.5

// A scene of a distance field to begin with. See it with `magichour view FILE`, and leave that window open: each time this file is saved, the picture
// changes. Lengths are in metres and y is up. Lines that begin with //@ are for magichour; scenes/README.md of the program lists them all.

// What is used is included, and what is not included costs nothing. glsl/README.md lists all distances and what joins them.
#include "distance/box.glsl"
#include "distance/smooth.glsl"
#include "distance/sphere.glsl"
#include "material/matte.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"

// A uniform with an annotation is a slider in the window, and a setting on the command line: --set blend=0.1
uniform float height;  //@ slider 1.1  min 0.2  max 2.5  unit m  label "height of the ball's centre"
uniform float blend;   //@ slider 0.3  min 0.01  max 1  unit m  label "how softly ball and box join"

// Each thing has a number of your own, by which its material is found.
const int GROUND = 0;
const int SOLID = 1;

// The distance from a point to the nearest surface, negative inside. It may be less than the true distance, which costs time, but never more, which loses
// surfaces.
float scene_distance(vec3 p) {
    float ball = distance_sphere(p, vec3(0.0, height, 0.0), 0.6);
    float block = distance_box(p, vec3(0.0, 0.35, 0.0), vec3(0.9, 0.35, 0.6));
    return op_smooth_union(ball, block, blend);
}

// Rays go to the field by march(), within a sphere around all of it; exact shapes may stand beside it. Nothing of the solid is thinner than march_thinnest,
// in metres. If you don't know it, leave that line out: it only saves time.
void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    march_thinnest = 0.3;
    march(ray, vec3(0.0, 1.0, 0.0), 2.6, SOLID, hit);
}

// A colour is the share of light that is thrown back, 0 to 1. hit.position and hit.normal are there to paint by.
Material scene_material(Hit hit) {
    if (hit.object == SOLID) return matte(mix(vec3(0.75, 0.3, 0.15), vec3(0.8, 0.7, 0.5), 0.5 + 0.5 * hit.normal.y));
    return matte(vec3(0.4));
}
