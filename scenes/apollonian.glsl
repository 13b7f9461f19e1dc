//@ title   Apollonian gasket
//@ look    "endless lace of spheres that touch one another, cut by a dome: four columns carry a roof, and light falls through the round openings"
//@ camera  eye 3.6 2.6 -5.5  target 0 0.9 0  fov 45
//@ sun     elevation 30  azimuth 130
//@ atmosphere earth
//@ size    512 512
//@ bound   0 1 0 2.4
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4
#include "distance/apollonian.glsl"
#include "distance/boolean.glsl"
#include "distance/offset.glsl"
#include "distance/sphere.glsl"
#include "material/matte.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"

uniform float inversion;   //@ slider 1.3    min 1.1    max 1.5   label "the squared radius in which space is turned inside out"
uniform float iterations;  //@ slider 5      min 1      max 12    label "how fine"
uniform float thickness;   //@ slider 0.006  min 0.002  max 0.03  label "of the spheres' skins"
uniform float radius;      //@ slider 2.6    min 0.5    max 2.6   label "of the dome that cuts the gasket"

const int GROUND = 0;
const int GASKET = 1;
// The gasket repeats every 2 metres. This place of it, between four columns, is the middle of the dome.
const vec3 BETWEEN = vec3(1.0, 0.0, 1.0);

float scene_distance(vec3 p) {
    float skins = op_round(distance_apollonian(p + BETWEEN, inversion, int(iterations + 0.5)), thickness);
    return op_intersection(skins, distance_sphere(p, vec3(0.0), radius));
}

// The gasket has a skin along y = 0, which the ground covers. A ground that lay closer would make rays along it slow.
void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.05, GROUND, hit);
    march(ray, vec3(0.0), radius, GASKET, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == GROUND) return matte(vec3(0.45));
    vec4 trap = vec4(0.0);
    distance_apollonian(hit.position + BETWEEN, inversion, int(iterations + 0.5), trap);
    vec3 color = mix(vec3(0.65, 0.28, 0.14), vec3(0.85, 0.75, 0.55), clamp(2.5 * sqrt(trap.w) - 0.6, 0.0, 1.0));
    return matte(mix(vec3(0.25, 0.4, 0.5), color, clamp(8.0 * trap.x, 0.0, 1.0)));
}
