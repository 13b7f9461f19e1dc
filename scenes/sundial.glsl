//@ title   Sundial
//@ look    "the pointer's shadow among the hours: sharp at its foot and soft at its tip, as wide as the sun's disk makes it"
//@ camera  eye 0 1.5 -1.7  target 0 0.42 -0.02  fov 36
//@ sun     elevation 50  azimuth 205
//@ atmosphere earth
//@ size    512 512
//@ sun-disk on
//@ exposure -3
//@ bound   0 0.4 0  0.47
//@ preset  noon      sun.elevation 60  sun.azimuth 180
//@ preset  sunset    sun.elevation 5   sun.azimuth 270  exposure -0.5
//@ preset  twilight  sun.elevation -2  sun.azimuth 280  exposure 4
//@ preset  wide-sun  sun.radius 3

// A sundial for 50 degrees of latitude. North is +z and west is +x, so east is on the right. The marks are where the pointer's shadow falls at
// full hours: tan(mark) = sin(latitude) tan(hour angle).
#include "material/matte.glsl"
#include "material/rough_metal.glsl"
#include "shape/capsule.glsl"
#include "shape/cylinder.glsl"
#include "shape/plane.glsl"

uniform float latitude;  //@ slider 50  min 20  max 80  unit deg  label "where the dial stands; the pointer is parallel to the earth's axis"
uniform float thickness; //@ slider 12  min 4  max 30  unit mm  label "of the pointer"

const int GROUND = 0;
const int FOOT = 1;
const int PLATE = 2;
const int POINTER = 3;

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    float angle = radians(latitude);
    vec3 foot = vec3(0.0, 0.42, -0.12);
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    hit_cylinder(ray, vec3(0.0), vec3(0.0, 0.39, 0.0), 0.12, FOOT, hit);
    hit_cylinder(ray, vec3(0.0, 0.38, 0.0), vec3(0.0, 0.42, 0.0), 0.45, PLATE, hit);
    hit_capsule(ray, foot, foot + 0.42 * vec3(0.0, sin(angle), cos(angle)), 0.0005 * thickness, POINTER, hit);
}

vec3 dial(vec3 position) {
    vec2 from_foot = vec2(-position.x, position.z + 0.12);
    float hour = atan(from_foot.x / sin(radians(latitude)), from_foot.y) * 12.0 / PI;
    // About the distance from the nearest mark in metres.
    float off = abs(fract(hour + 0.5) - 0.5) * PI / 12.0 * length(from_foot);
    float ring = length(vec2(position.x, position.z));
    bool mark = off < 0.005 && ring > 0.3 && ring < 0.41;
    return mark ? vec3(0.08) : vec3(0.72, 0.68, 0.6);
}

Material scene_material(Hit hit) {
    if (hit.object == POINTER) return rough_metal(copper(), 0.5);
    if (hit.object == PLATE) return matte(dial(hit.position));
    if (hit.object == FOOT) return matte(vec3(0.55, 0.52, 0.47));
    return matte(vec3(0.3, 0.33, 0.2));
}
