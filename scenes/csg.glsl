//@ title   Solids made of solids
//@ look    "nine operators on a ball and a box: sharp edges where they should be sharp, round where they flow into each other"
//@ camera  eye 0 5 -6  target 0 0.25 -0.25  fov 34
//@ sun     elevation 35  azimuth 140
//@ atmosphere earth
//@ size    512 512
//@ bound   0 0.5 0  3
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4

// Seen from the camera, from left to right:
//   * in the back row union, intersection and subtraction;
//   * in the middle row the same three, smooth;
//   * in the front row a shell whose lid is cut off, a rounded and rotated box, and an elongated torus.
#include "distance/boolean.glsl"
#include "distance/box.glsl"
#include "distance/elongate.glsl"
#include "distance/move.glsl"
#include "distance/offset.glsl"
#include "distance/smooth.glsl"
#include "distance/sphere.glsl"
#include "distance/torus.glsl"
#include "material/matte.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"

uniform float k;         //@ slider 0.25  min 0.01  max 0.5  unit m  label "how far surfaces flow into each other"
uniform float thickness; //@ slider 0.08  min 0.02  max 0.3  unit m  label "of the shell"
uniform float angle;     //@ slider 30  min 0  max 90  unit deg  label "of the rounded box"

const int GROUND = 0;
const int SOLID = 1;

float ball(vec3 p) {
    return distance_sphere(p, vec3(0.2, 0.75, -0.2), 0.42);
}

float box(vec3 p) {
    return distance_box(p, vec3(-0.08, 0.42, 0.08), vec3(0.4));
}

float scene_distance(vec3 p) {
    vec3 left = vec3(1.6, 0.0, 0.0);
    vec3 back = vec3(0.0, 0.0, 1.6);
    float d = op_union(ball(p - left - back), box(p - left - back));
    d = min(d, op_intersection(ball(p - back), box(p - back)));
    d = min(d, op_subtraction(box(p + left - back), ball(p + left - back)));
    d = min(d, op_smooth_union(ball(p - left), box(p - left), k));
    d = min(d, op_smooth_intersection(ball(p), box(p), k));
    d = min(d, op_smooth_subtraction(box(p + left), ball(p + left), k));

    float shell = op_shell(distance_sphere(p - left + back, vec3(0.0, 0.5, 0.0), 0.44), thickness);
    d = min(d, op_intersection(shell, p.y - 0.7));
    vec3 turned = op_rotate(op_translate(p, vec3(0.0, 0.55, 0.0) - back), vec3(0.0, 0.6, 0.8), radians(angle));
    d = min(d, op_round(distance_box(turned, vec3(0.0), vec3(0.22, 0.3, 0.22)), 0.12));
    vec3 gap = op_elongate(p + left + back - vec3(0.0, 0.4, 0.0), vec3(0.3, 0.25, 0.0));
    return min(d, distance_torus(gap, vec3(0.0), vec3(0.0, 0.0, 1.0), 0.22, 0.1));
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    march_thinnest = thickness;
    march(ray, vec3(0.0, 0.65, 0.0), vec3(2.35, 0.65, 2.35), SOLID, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == GROUND) return matte(vec3(0.45));
    float row = floor(hit.position.z / 1.6 + 0.5);
    return matte(row > 0.5 ? vec3(0.75, 0.32, 0.2) : row > -0.5 ? vec3(0.25, 0.5, 0.7) : vec3(0.75, 0.62, 0.25));
}
