//@ title   Ball
//@ camera  eye 0 1 -4  target 0 0.5 0  fov 60
//@ sun     elevation 30  azimuth 60
#include "material/matte.glsl"
#include "shape/plane.glsl"
#include "shape/sphere.glsl"

uniform float size; //@ slider 0.5 min 0.1 max 2 unit m label "radius of the ball"

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);
    hit_sphere(ray, vec3(0.0, size, 0.0), size, 1, hit);
}

Material scene_material(Hit hit) {
    return matte(hit.object == 1 ? vec3(0.8, 0.2, 0.1) : vec3(0.5));
}
