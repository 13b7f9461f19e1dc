//@ title   Materials
//@ look    "the sky upside down in the glass, gold and copper at different finish, and the sun's bright patch behind the glass ball"
//@ camera  eye 0 2.2 -6.5  target 0 0.6 0  fov 38
//@ sun     elevation 40  azimuth 120
//@ atmosphere earth
//@ size    640 480
//@ bound   -2.4 0.7 0.9  0.7
//@ bound   -0.9 0.7 1.5  0.7
//@ bound   0.9 0.7 1.5  0.7
//@ bound   2.4 0.7 0.9  0.7
//@ bound   0 0.7 -0.9  0.7
//@ mirror-sphere  2.4 0.7 0.9  0.7
//@ preset  noon    sun.elevation 60
//@ preset  sunset  sun.elevation 5  exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4

// Balls of glass, gold, copper, aluminium and mirror on sand.
#include "color/noise.glsl"
#include "material/glass.glsl"
#include "material/matte.glsl"
#include "material/mirror.glsl"
#include "material/rough_metal.glsl"
#include "shape/plane.glsl"
#include "shape/sphere.glsl"

uniform float ior;    //@ slider 1.5  min 1  max 2.5  label "index of refraction of the glass"
uniform float finish; //@ slider 0.3  min 0  max 1  label "roughness of the gold; the copper's is half more, the aluminium's half"

const int GROUND = 0;
const int GOLD = 1;
const int COPPER = 2;
const int ALUMINIUM = 3;
const int MIRROR = 4;
const int GLASS = 5;

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    hit_sphere(ray, vec3(-2.4, 0.7, 0.9), 0.7, GOLD, hit);
    hit_sphere(ray, vec3(-0.9, 0.7, 1.5), 0.7, COPPER, hit);
    hit_sphere(ray, vec3(0.9, 0.7, 1.5), 0.7, ALUMINIUM, hit);
    hit_sphere(ray, vec3(2.4, 0.7, 0.9), 0.7, MIRROR, hit);
    hit_sphere(ray, vec3(0.0, 0.7, -0.9), 0.7, GLASS, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == GOLD) return rough_metal(gold(), finish);
    if (hit.object == COPPER) return rough_metal(copper(), min(1.5 * finish, 1.0));
    if (hit.object == ALUMINIUM) return rough_metal(aluminium(), 0.5 * finish);
    if (hit.object == MIRROR) return mirror(vec3(0.95));
    if (hit.object == GLASS) return glass(ior);
    return matte(mix(vec3(0.42, 0.33, 0.22), vec3(0.52, 0.42, 0.29), noise_octaves(4.0 * hit.position, 3)));
}
