//@ title   Arches
//@ look    "an arcade with its vault: shade that deepens softly from the open side to the wall, without lines at the arches' rims"
//@ camera  eye 0.9 1.6 -9  target -0.35 1.75 0  fov 58
//@ sun     elevation 25  azimuth 70
//@ atmosphere earth
//@ size    640 480
//@ exposure 0.5
//@ preset  noon      sun.elevation 60  exposure 0.5
//@ preset  sunset    sun.elevation 5   exposure 1
//@ preset  twilight  sun.elevation -2  exposure 4.5
//@ preset  garden    camera.eye 11,1.7,-6  camera.target 1,1.6,-0.5  exposure 0
#include "color/checker.glsl"
#include "distance/boolean.glsl"
#include "distance/box.glsl"
#include "distance/cylinder.glsl"
#include "distance/repeat.glsl"
#include "material/matte.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"

uniform float spacing; //@ slider 2.6  min 2  max 4  unit m  label "from arch to arch"
uniform float opening; //@ slider 2  min 0.8  max 2.6  unit m  label "width of an arch"
uniform float wall;    //@ slider 0.5  min 0.1  max 1  unit m  label "thickness of the wall"

// The number of arches along z.
const float COUNT = 6.0;
// The height of the arcade in metres.
const float HIGH = 3.6;
const int GROUND = 0;
const int ARCADE = 1;

// The opening of an arch, across x: a door with half a disk on top.
float arch(vec3 p) {
    float radius = min(0.5 * opening, 0.47 * spacing);
    float door = distance_box(p, vec3(0.0), vec3(2.0, 1.6, radius));
    return op_union(door, distance_cylinder(p, vec3(-2.0, 1.6, 0.0), vec3(2.0, 1.6, 0.0), radius));
}

float scene_distance(vec3 p) {
    float half_length = 0.5 * COUNT * spacing;
    // The arcade is a block without the vaulted passage along z and without the arches' openings.
    float block = distance_box(p, vec3(0.0, 0.5 * HIGH, 0.0), vec3(1.3 + wall, 0.5 * HIGH, half_length));
    float room = distance_box(p, vec3(0.0), vec3(1.3, 1.8, half_length + 1.0));
    float vault = distance_cylinder(p, vec3(0.0, 1.8, -half_length - 1.0), vec3(0.0, 1.8, half_length + 1.0), 1.3);
    float arches = INFINITY;
    vec3 q = p - vec3(1.3 + 0.5 * wall, 0.0, 0.0);
    for (int i = 0; i < 2; i++) arches = min(arches, arch(repeat_cell(q, vec3(0.0, 0.0, spacing), vec3(COUNT), i)));
    return op_subtraction(block, min(op_union(room, vault), arches));
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    vec3 reach = vec3(1.3 + wall, 0.5 * HIGH, 0.5 * COUNT * spacing);
    march_thinnest = min(wall, 0.1);
    march(ray, vec3(0.0, 0.5 * HIGH, 0.0), reach, ARCADE, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == ARCADE) return matte(vec3(0.78, 0.66, 0.5));
    return matte(checker(2.0 * hit.position, vec3(0.5, 0.42, 0.36), vec3(0.36, 0.32, 0.3)));
}
