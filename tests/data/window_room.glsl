//@ title   A room with a window, under an even sky
//@ camera  eye 1.6 1.4 -2.2  target -0.8 1.0 1.5  fov 70
//@ sun     elevation 30 azimuth 0
//@ sky     uniform:1
//@ size    128 128
//@ portal  -2.2 1.5 0  90 0  0.7 1.2
// tools/peer_error.py has the same room for another renderer.
#include "material/matte.glsl"
#include "shape/box.glsl"

const int WHITE = 0;
const int RED = 1;
const int FLOOR = 2;
const int BLOCK = 3;

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_box(ray, vec3(0.0, -0.1, 0.0), vec3(2.2, 0.1, 3.2), FLOOR, hit);
    hit_box(ray, vec3(0.0, 2.7, 0.0), vec3(2.2, 0.1, 3.2), WHITE, hit);
    hit_box(ray, vec3(2.1, 1.3, 0.0), vec3(0.1, 1.4, 3.2), WHITE, hit);
    hit_box(ray, vec3(0.0, 1.3, -3.1), vec3(2.2, 1.4, 0.1), WHITE, hit);
    hit_box(ray, vec3(0.0, 1.3, 3.1), vec3(2.2, 1.4, 0.1), RED, hit);
    // The wall around the window, which is 0.7 m wide and reaches from 0.9 to 2.1 m.
    hit_box(ray, vec3(-2.1, 0.4, 0.0), vec3(0.1, 0.5, 3.2), WHITE, hit);
    hit_box(ray, vec3(-2.1, 2.4, 0.0), vec3(0.1, 0.3, 3.2), WHITE, hit);
    hit_box(ray, vec3(-2.1, 1.3, -1.95), vec3(0.1, 1.4, 1.25), WHITE, hit);
    hit_box(ray, vec3(-2.1, 1.3, 1.95), vec3(0.1, 1.4, 1.25), WHITE, hit);
    hit_box(ray, vec3(-0.3, 0.375, 1.0), vec3(0.5, 0.425, 0.5), BLOCK, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == BLOCK) return matte(vec3(0.2, 0.35, 0.7));
    if (hit.object == FLOOR) return matte(vec3(0.45, 0.4, 0.35));
    if (hit.object == RED) return matte(vec3(0.7, 0.2, 0.15));
    return matte(vec3(0.7));
}
