//@ title   Menger sponge
//@ look    "a cube with holes in holes, exact at every level: sharp edges, and shafts through which the light falls"
//@ camera  eye 2.2 2.5 -3.3  target 0.05 0.9 0  fov 43
//@ sun     elevation 30  azimuth 130
//@ atmosphere earth
//@ size    512 512
//@ bound   0 1 0 1.8
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4
#include "distance/menger.glsl"
#include "material/matte.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"

uniform float levels;  //@ slider 4  min 0  max 6  label "of holes in holes"

const int GROUND = 0;
const int SPONGE = 1;
const vec3 MIDDLE = vec3(0.0, 1.02, 0.0);

float scene_distance(vec3 p) {
    return distance_menger(p, MIDDLE, 1.0, int(levels + 0.5));
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    march(ray, MIDDLE, 1.7321, SPONGE, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == GROUND) return matte(vec3(0.45));
    vec4 trap = vec4(0.0);
    distance_menger(hit.position, MIDDLE, 1.0, int(levels + 0.5), trap);
    return matte(mix(vec3(0.7, 0.3, 0.18), vec3(0.85, 0.75, 0.55), clamp(3.0 * (trap.y - 1.0 / 3.0), 0.0, 1.0)));
}
