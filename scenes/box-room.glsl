//@ title   Box room
//@ look    "the lamp in the mirror, its light gathered by the glass on the floor, the walls' colours on the ceiling"
//@ camera  eye 0 1.5 -2.9  target 0 1.3 0  fov 60
//@ sky     uniform:0
//@ size    512 512
//@ exposure -1
//@ emitter-sphere  0.2 2.2 0.5  lamp
//@ mist    off  extinction smoke  albedo 0.95 0.95 0.95  g 0.4  box 0 1.5 0  2 1.5 3
//@ preset  smoke   mist on

// A closed room of matte walls with a lamp, a mirror ball and a glass ball. tools/peer_box_room.py renders the same room with Mitsuba.
#include "material/emitter.glsl"
#include "material/glass.glsl"
#include "material/matte.glsl"
#include "material/mirror.glsl"
#include "shape/box.glsl"
#include "shape/sphere.glsl"

uniform float lamp;      //@ slider 0.4  min 0.02  max 0.7  unit m  label "radius of the lamp"
uniform float smoke;     //@ slider 0.2  min 0  max 1  unit /m  label "extinction of the smoke"
uniform float radiance;  //@ slider 10  max 100  label "of the lamp"

const int WALLS = 0;
const int LAMP = 1;
const int MIRROR = 2;
const int GLASS = 3;

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_box(ray, vec3(0.0, 1.5, 0.0), vec3(2.0, 1.5, 3.0), WALLS, hit);
    hit_sphere(ray, vec3(0.2, 2.2, 0.5), lamp, LAMP, hit);
    hit_sphere(ray, vec3(-1.0, 0.7, 1.2), 0.7, MIRROR, hit);
    hit_sphere(ray, vec3(0.9, 0.7, 0.2), 0.7, GLASS, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == LAMP) return emitter(radiance * vec3(1.0, 0.85, 0.7));
    if (hit.object == MIRROR) return mirror(vec3(0.9));
    if (hit.object == GLASS) return glass(1.5);
    if (hit.normal.x > 0.5) return matte(vec3(0.65, 0.1, 0.08));
    if (hit.normal.x < -0.5) return matte(vec3(0.12, 0.45, 0.15));
    return matte(vec3(0.7));
}
