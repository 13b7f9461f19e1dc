//@ title   Fences
//@ look    "wires thinner than a pixel and rails seen along: fine lines without gaps or stairs, to where all run together"
//@ camera  eye 0.5 0.85 -2.6  target 0.1 0.72 1  fov 50
//@ sun     elevation 20  azimuth 80
//@ atmosphere earth
//@ size    640 480
//@ bound   1.5 0.6 1.5  0.7
//@ bound   -1 0.6 1.5  0.7
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4
//@ preset  along     camera.eye 1.2,0.97,1.2  camera.target -3,0.8,1.55  camera.fov 40

// A fence of posts and rails leads away from the camera. A fence of posts and wires stands across the view.
#include "color/noise.glsl"
#include "material/matte.glsl"
#include "shape/box.glsl"
#include "shape/cylinder.glsl"
#include "shape/plane.glsl"

uniform float wire;    //@ slider 6  min 0.5  max 20  unit mm  label "thickness of the wires"
uniform float rail;    //@ slider 80  min 10  max 200  unit mm  label "height of the rails"
uniform float spacing; //@ slider 2.5  min 1  max 10  unit m  label "from post to post"

// The number of posts of each fence.
const int POSTS = 10;
// The z of the wires in metres.
const float ACROSS = 1.5;
const int GROUND = 0;
const int WOOD = 1;
const int WIRE = 2;

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    float half_length = 0.5 * spacing * float(POSTS - 1);
    for (int i = 0; i < 3; i++) {
        vec3 centre = vec3(1.5, 0.3 + 0.35 * float(i), ACROSS + half_length - 3.0 * spacing);
        hit_box(ray, centre, vec3(0.02, 0.0005 * rail, half_length), WOOD, hit);
    }
    for (int i = 0; i < 6; i++) {
        vec3 end = vec3(1.5, 0.18 * float(i + 1), ACROSS);
        hit_cylinder(ray, end, end - vec3(2.0 * half_length, 0.0, 0.0), 0.0005 * wire, WIRE, hit);
    }
    for (int i = 0; i < POSTS; i++) {
        float z = ACROSS + spacing * float(i - 3);
        hit_box(ray, vec3(1.5, 0.6, z), vec3(0.06, 0.6, 0.06), WOOD, hit);
        vec3 foot = vec3(1.5 - spacing * float(i), 0.0, ACROSS);
        hit_cylinder(ray, foot, foot + vec3(0.0, 1.2, 0.0), 0.05, WOOD, hit);
    }
}

Material scene_material(Hit hit) {
    if (hit.object == WIRE) return matte(vec3(0.65));
    float grain = noise(hit.object == WOOD ? 20.0 * hit.position : 2.0 * hit.position);
    if (hit.object == WOOD) return matte(mix(vec3(0.3, 0.22, 0.15), vec3(0.5, 0.38, 0.26), grain));
    return matte(mix(vec3(0.2, 0.28, 0.1), vec3(0.35, 0.4, 0.18), grain));
}
