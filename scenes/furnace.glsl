//@ title   White furnace
//@ look    "nothing: where every surface reflects all light and the surroundings are 1, every pixel is 1"
//@ camera  eye 0 2 -4  target 0 0 0  fov 90
//@ size    256 256
//@ sky     uniform:1

// Every pixel must be 1. Any other picture shows a fault: light that a bounce loses or makes up, a seam, or a ray that starts inside a surface.
#include "material/matte.glsl"
#include "material/mirror.glsl"
#include "shape/plane_minus_sphere.glsl"
#include "shape/sphere.glsl"

uniform float albedo;  //@ slider 1  label "albedo of the matte surfaces"
uniform float tint;    //@ slider 1  label "what the mirror reflects"

const int GROUND = 0;
const int MATTE_BALL = 1;
const int MIRROR_BALL = 2;

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane_minus_sphere(ray, vec3(0.0, 1.0, 0.0), 0.0, vec3(0.0), 2.0, GROUND, hit);
    hit_sphere(ray, vec3(-1.0, -0.2, 0.0), 0.9, MATTE_BALL, hit);
    hit_sphere(ray, vec3(1.0, 0.6, 0.0), 0.9, MIRROR_BALL, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == MIRROR_BALL) return mirror(vec3(tint));
    return matte(vec3(albedo));
}
