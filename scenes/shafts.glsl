//@ title   Shafts
//@ look    "a hall with mist in it: shafts of sunlight from the windows, with sharp edges, that fade across the hall and end in patches on the floor"
//@ camera  eye -2.6 1.7 -1.4  target 0.9 2.1 6  fov 62
//@ sun     elevation 32  azimuth 78
//@ sun-disk on
//@ atmosphere earth
//@ size    640 480
//@ exposure 0.5
//@ mist    extinction density  albedo 0.95 0.95 0.95  g forward  box 0 3 6  4.2 3.2 8.2
//@ preset  clear    mist off
//@ preset  thick    density 0.2  exposure 1
//@ preset  noon     sun.elevation 60
//@ preset  sunset   sun.elevation 5   exposure 1
//@ preset  twilight sun.elevation -2  exposure 5
//@ preset  against  camera.eye -3.4,1.4,9  camera.target 3,2.6,6
#include "color/checker.glsl"
#include "material/matte.glsl"
#include "shape/box.glsl"
#include "shape/cylinder.glsl"

uniform float density; //@ slider 0.06  min 0  max 0.5  unit /m  label "extinction of the mist"
uniform float forward; //@ slider 0.5  min -0.9  max 0.9  label "how much the mist scatters forward"
uniform float opening; //@ slider 0.8  min 0.1  max 1.8  unit m  label "width of a window"

const int FLOOR = 0;
const int WALL = 1;
const int COLUMN = 2;

// A hall of 8 m by 16 m, 6 m high, with windows toward +x every 2.4 m.
void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_box(ray, vec3(0.0, -0.5, 6.0), vec3(40.0, 0.5, 40.0), FLOOR, hit);
    hit_box(ray, vec3(0.0, 6.2, 6.0), vec3(4.4, 0.2, 8.4), WALL, hit);
    hit_box(ray, vec3(-4.2, 3.0, 6.0), vec3(0.2, 3.2, 8.4), WALL, hit);
    hit_box(ray, vec3(0.0, 3.0, -2.2), vec3(4.4, 3.2, 0.2), WALL, hit);
    hit_box(ray, vec3(0.0, 3.0, 14.2), vec3(4.4, 3.2, 0.2), WALL, hit);
    hit_box(ray, vec3(4.2, 0.5, 6.0), vec3(0.2, 0.7, 8.4), WALL, hit);
    hit_box(ray, vec3(4.2, 5.6, 6.0), vec3(0.2, 0.6, 8.4), WALL, hit);
    for (int i = 0; i < 8; i++) {
        hit_box(ray, vec3(4.2, 3.0, -2.4 + 2.4 * float(i)), vec3(0.2, 2.8, 1.2 - 0.5 * opening), WALL, hit);
    }
    for (int i = 0; i < 3; i++) {
        vec3 foot = vec3(-1.6, 0.0, 4.8 + 3.6 * float(i));
        hit_cylinder(ray, foot, foot + vec3(0.0, 6.1, 0.0), 0.28, COLUMN, hit);
    }
}

Material scene_material(Hit hit) {
    if (hit.object == FLOOR) return matte(checker(hit.position, vec3(0.5, 0.42, 0.34), vec3(0.25, 0.22, 0.2)));
    if (hit.object == COLUMN) return matte(vec3(0.75, 0.7, 0.62));
    return matte(vec3(0.68, 0.62, 0.54));
}
