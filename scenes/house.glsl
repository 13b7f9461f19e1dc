//@ title   House
//@ look    "all light comes by one window: bright on the floor and far wall, the red and green walls' colours in the corners"
//@ camera  eye 1.7 1.5 -2.4  target -0.9 1.1 1.4  fov 70
//@ sun     elevation 40  azimuth 250
//@ atmosphere earth
//@ size    512 512
//@ exposure 3.5
//@ portal  -2.4 1.5 0  90 0  width 1.2
//@ preset  noon      sun.elevation 60  exposure 3.5
//@ preset  sunset    sun.elevation 5   exposure 4
//@ preset  twilight  sun.elevation -2  exposure 7.5
//@ preset  outside   camera.eye -7,2,-5  camera.target 0,1.3,0  camera.fov 45  exposure 0

// This scene is hard to render, because few of the paths in the room leave by the window. The walls are boxes that run into each other.
#include "color/checker.glsl"
#include "material/matte.glsl"
#include "shape/box.glsl"
#include "shape/plane.glsl"
#include "shape/rounded_box.glsl"
#include "shape/sphere.glsl"

uniform float width;  //@ slider 1.6  min 0.3  max 2.8  unit m  label "of the window"
uniform float albedo; //@ slider 0.8  label "of the white walls"

const int GROUND = 0;
const int WALL = 1;
const int TABLE = 2;
const int BALL = 3;
// Half of the walls' thickness in metres.
const float THICK = 0.1;

// The room is 4.4 m by 6 m and 2.6 m high; the window is in the wall at -x, from 0.9 m to 2.1 m.
void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), -0.3, GROUND, hit);
    hit_box(ray, vec3(0.0, -0.2, 0.0), vec3(2.4, 0.2, 3.2), WALL, hit);
    hit_box(ray, vec3(0.0, 2.7, 0.0), vec3(2.6, THICK, 3.4), WALL, hit);
    hit_box(ray, vec3(2.3, 1.3, 0.0), vec3(THICK, 1.4, 3.2), WALL, hit);
    hit_box(ray, vec3(0.0, 1.3, 3.1), vec3(2.4, 1.4, THICK), WALL, hit);
    hit_box(ray, vec3(0.0, 1.3, -3.1), vec3(2.4, 1.4, THICK), WALL, hit);
    // Around the window: below, above, and to its sides.
    float side = 0.5 * (3.2 - 0.5 * width);
    hit_box(ray, vec3(-2.3, 0.4, 0.0), vec3(THICK, 0.5, 3.2), WALL, hit);
    hit_box(ray, vec3(-2.3, 2.4, 0.0), vec3(THICK, 0.3, 3.2), WALL, hit);
    hit_box(ray, vec3(-2.3, 1.3, -3.2 + side), vec3(THICK, 1.4, side), WALL, hit);
    hit_box(ray, vec3(-2.3, 1.3, 3.2 - side), vec3(THICK, 1.4, side), WALL, hit);
    hit_rounded_box(ray, vec3(-0.4, 0.7, 0.8), vec3(0.6, 0.04, 0.9), 0.02, TABLE, hit);
    hit_box(ray, vec3(-0.4, 0.34, 0.8), vec3(0.1, 0.34, 0.4), TABLE, hit);
    hit_sphere(ray, vec3(-0.4, 0.92, 0.6), 0.18, BALL, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == TABLE) return matte(vec3(0.45, 0.3, 0.18));
    if (hit.object == BALL) return matte(vec3(0.2, 0.35, 0.7));
    if (hit.object == GROUND) return matte(vec3(0.3, 0.35, 0.2));
    // The distances from the room's walls in metres, along each axis. A negative one means that the place is outside of the room.
    vec3 in_room = vec3(2.2, 1.3, 3.0) - abs(hit.position - vec3(0.0, 1.3, 0.0));
    if (min(min(in_room.x, in_room.y), in_room.z) < -0.001) return matte(vec3(albedo));
    if (hit.position.y < 0.001) return matte(checker(2.0 * hit.position, vec3(0.6, 0.45, 0.3), vec3(0.45, 0.32, 0.2)));
    if (in_room.z < 0.001 && hit.position.z > 0.0) return matte(vec3(0.7, 0.2, 0.15));
    if (in_room.x < 0.001 && hit.position.x > 0.0) return matte(vec3(0.3, 0.6, 0.25));
    return matte(vec3(albedo));
}
