//@ title   Shapes
//@ look    "the ten shapes, exact; the checkbox marches their distances, and nothing but the time must change"
//@ camera  eye 0 5 -6.2  target 0 0.3 0  fov 33
//@ sun     elevation 35  azimuth 140
//@ atmosphere earth
//@ size    640 480
//@ bound   0 0.5 0  3.35
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4
//@ preset  marched   marched 1

// Shapes on a plane. Seen from the camera, from left to right, these are cone, cylinder, capsule, torus and disk in the back row; and sphere, box,
// rounded box and ellipsoid in the front row.
#include "distance/box.glsl"
#include "distance/capsule.glsl"
#include "distance/cone.glsl"
#include "distance/cylinder.glsl"
#include "distance/disk.glsl"
#include "distance/ellipsoid.glsl"
#include "distance/offset.glsl"
#include "distance/rounded_box.glsl"
#include "distance/sphere.glsl"
#include "distance/torus.glsl"
#include "material/matte.glsl"
#include "shape/box.glsl"
#include "shape/capsule.glsl"
#include "shape/cone.glsl"
#include "shape/cylinder.glsl"
#include "shape/disk.glsl"
#include "shape/ellipsoid.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"
#include "shape/rounded_box.glsl"
#include "shape/sphere.glsl"
#include "shape/torus.glsl"

uniform bool marched;  //@ checkbox off  label "march the shapes' distances"
uniform float corners; //@ slider 0.15  min 0.01  max 0.4  unit m  label "radius of the rounded box's edges"
uniform float flat_m;  //@ slider 0.3  min 0.1  max 0.6  unit m  label "half of the ellipsoid's height"

const vec3 TILT = vec3(0.0, 0.8, -0.6);
const int GROUND = 0;
const int SHAPE = 1;
// The disk is the only shape with two sides and no inside.
const int DISK = 2;

float scene_distance(vec3 p) {
    float d = distance_cone(p, vec3(2.6, 0.0, 1.0), vec3(2.6, 1.1, 1.0), 0.5);
    d = min(d, distance_cylinder(p, vec3(1.3, 0.0, 1.0), vec3(1.3, 1.0, 1.0), 0.45));
    d = min(d, distance_capsule(p, vec3(0.0, 0.3, 1.0), vec3(0.0, 0.9, 1.0), 0.3));
    d = min(d, distance_torus(p, vec3(-1.3, 0.5, 1.0), TILT, 0.4, 0.15));
    // A disk has no inside, so it is made 2 mm thick to each side.
    d = min(d, op_round(distance_disk(p, vec3(-2.6, 0.5, 1.0), TILT, 0.5), 0.002));
    d = min(d, distance_sphere(p, vec3(2.0, 0.5, -1.0), 0.5));
    d = min(d, distance_box(p, vec3(0.7, 0.45, -1.0), vec3(0.45)));
    d = min(d, distance_rounded_box(p, vec3(-0.7, 0.45, -1.0), vec3(0.45), corners));
    return min(d, distance_ellipsoid(p, vec3(-2.0, flat_m, -1.0), vec3(0.55, flat_m, 0.4)));
}

void hit_shapes(Ray ray, INOUT(Hit) hit) {
    hit_cone(ray, vec3(2.6, 0.0, 1.0), vec3(2.6, 1.1, 1.0), 0.5, SHAPE, hit);
    hit_cylinder(ray, vec3(1.3, 0.0, 1.0), vec3(1.3, 1.0, 1.0), 0.45, SHAPE, hit);
    hit_capsule(ray, vec3(0.0, 0.3, 1.0), vec3(0.0, 0.9, 1.0), 0.3, SHAPE, hit);
    hit_torus(ray, vec3(-1.3, 0.5, 1.0), TILT, 0.4, 0.15, SHAPE, hit);
    hit_disk(ray, vec3(-2.6, 0.5, 1.0), TILT, 0.5, DISK, hit);
    hit_sphere(ray, vec3(2.0, 0.5, -1.0), 0.5, SHAPE, hit);
    hit_box(ray, vec3(0.7, 0.45, -1.0), vec3(0.45), SHAPE, hit);
    hit_rounded_box(ray, vec3(-0.7, 0.45, -1.0), vec3(0.45), corners, SHAPE, hit);
    hit_ellipsoid(ray, vec3(-2.0, flat_m, -1.0), vec3(0.55, flat_m, 0.4), SHAPE, hit);
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    if (marched) march(ray, vec3(0.0, 0.5, 0.0), 3.4, SHAPE, hit);
    else hit_shapes(ray, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == GROUND) return matte(vec3(0.45));
    bool back = hit.position.z > 0.0;
    float place = back ? floor(hit.position.x / 1.3 + 0.5) : floor(hit.position.x / 1.35) - 6.5;
    // Each shape has a hue of its own.
    return matte(0.5 + 0.25 * cos(1.3 * place + vec3(0.0, 2.1, 4.2)));
}
