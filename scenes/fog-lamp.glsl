//@ title   Fog lamp
//@ look    "lamps in fog at dusk: a warm glow about each, weaker the farther it is, the posts' shadows in it, and the pool of light on the road"
//@ camera  eye -2.2 1.6 -6.5  target 0.5 2.0 2  fov 52
//@ sun     elevation -3  azimuth 25
//@ atmosphere earth
//@ size    640 480
//@ exposure 2.5
//@ emitter-sphere  1.6 3.2 0   globe
//@ emitter-sphere  1.6 3.2 9   globe
//@ emitter-sphere  1.6 3.2 18  globe
//@ mist    extinction fog  albedo 0.97 0.97 0.97  g forward  falloff deep
//@ preset  clear    mist off
//@ preset  thick    fog 0.3
//@ preset  noon     sun.elevation 60  exposure -1
//@ preset  sunset   sun.elevation 5   exposure 0.5
//@ preset  twilight sun.elevation -2  exposure 2
#include "color/noise.glsl"
#include "material/emitter.glsl"
#include "material/matte.glsl"
#include "shape/box.glsl"
#include "shape/cylinder.glsl"
#include "shape/plane.glsl"
#include "shape/sphere.glsl"

uniform float fog;      //@ slider 0.06  min 0  max 0.5  unit /m  label "extinction of the fog on the ground"
uniform float forward;  //@ slider 0.6  min -0.9  max 0.9  label "how much the fog scatters forward"
uniform float deep;     //@ slider 8  min 0.5  max 40  unit m  label "height in which the fog thins to 1/e"
uniform float globe;    //@ slider 0.25  min 0.05  max 0.4  unit m  label "radius of a lamp"
uniform float radiance; //@ slider 6  max 100  label "of the lamps"

const int ROAD = 0;
const int KERB = 1;
const int POST = 2;
const int LAMP = 3;
const int WALL = 4;

// A road along +z with lamps every 9 m on its right, and a wall behind them.
void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, ROAD, hit);
    hit_box(ray, vec3(2.2, 0.0, 20.0), vec3(1.0, 0.14, 40.0), KERB, hit);
    hit_box(ray, vec3(3.4, 0.6, 20.0), vec3(0.2, 0.6, 40.0), WALL, hit);
    for (int i = 0; i < 3; i++) {
        vec3 foot = vec3(1.6, 0.0, 9.0 * float(i));
        hit_cylinder(ray, foot, foot + vec3(0.0, 3.25 - globe, 0.0), 0.06, POST, hit);
        hit_cylinder(ray, foot, foot + vec3(0.0, 0.6, 0.0), 0.14, POST, hit);
        hit_sphere(ray, foot + vec3(0.0, 3.2, 0.0), globe, LAMP, hit);
    }
    for (int i = 0; i < 8; i++) {
        vec3 foot = vec3(-3.4, 0.0, -3.0 + 3.0 * float(i));
        hit_cylinder(ray, foot, foot + vec3(0.0, 0.8, 0.0), 0.12, POST, hit);
    }
}

Material scene_material(Hit hit) {
    if (hit.object == LAMP) return emitter(radiance * vec3(1.0, 0.62, 0.28));
    if (hit.object == POST) return matte(vec3(0.06, 0.07, 0.07));
    if (hit.object == KERB) return matte(vec3(0.4, 0.39, 0.37));
    if (hit.object == WALL) return matte(vec3(0.35, 0.25, 0.2));
    return matte(vec3(0.2 + 0.2 * noise_octaves(6.0 * hit.position, 3)));
}
