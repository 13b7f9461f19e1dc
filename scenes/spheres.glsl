//@ title   Spheres
//@ look    "ten thousand spheres on a spiral: long shades at sunset, no cracks, and all of them again in the mirror ball"
//@ camera  eye 0 2 -8  target 0 0.7 0  fov 42
//@ sun     elevation 5  azimuth 115
//@ atmosphere earth
//@ size    768 512
//@ sun-disk on
//@ exposure -1
//@ spheres count
//@ mirror-sphere  0 ball 0 ball
//@ preset  noon      sun.elevation 60  exposure -3
//@ preset  sunset    sun.elevation 5   exposure -1
//@ preset  twilight  sun.elevation -2  exposure 4

#include "material/matte.glsl"
#include "material/mirror.glsl"
#include "math/hash.glsl"
#include "shape/plane.glsl"
#include "shape/sphere.glsl"
#include "shape/spheres.glsl"

uniform float count;    //@ slider 10000  min 0  max 100000  label "number of spheres"
uniform float spread;   //@ slider 12  min 3  max 100  unit m  label "radius of the field"
uniform float largest;  //@ slider 0.3  min 0.01  max 2  unit m  label "radius of the largest spheres"
uniform float ball;     //@ slider 1.2  min 0.1  max 2  unit m  label "radius of the mirror ball"

const int GROUND = 0;
const int BALL = 1;
const int FIELD = 2;

// The spheres lie on Vogel's spiral, which is equally dense everywhere. No sphere is larger than half of the distance to its neighbours.
vec4 scene_sphere(int i) {
    float share = (float(i) + 0.5) / count;
    float from = 1.1 * ball;
    float distance = sqrt(mix(from * from, spread * spread, share));
    float angle = 2.39996323 * float(i);
    float room = 0.85 * sqrt((spread * spread - from * from) / count);
    float size = unit_float(hash_3(uvec3(uint(i), 1u, 0u)).x);
    float radius = min(largest, room) * mix(0.25, 1.0, size * size);
    return vec4(distance * sin(angle), radius, distance * cos(angle), radius);
}

vec3 color_of(int i) {
    uvec3 bits = hash_3(uvec3(uint(i), 2u, 0u));
    float chosen = unit_float(bits.x);
    vec3 color = vec3(0.08, 0.3, 0.38);
    if (chosen < 0.88) color = vec3(0.85, 0.55, 0.12);
    if (chosen < 0.7) color = vec3(0.75, 0.22, 0.12);
    if (chosen < 0.45) color = vec3(0.85, 0.8, 0.72);
    return (0.7 + 0.3 * unit_float(bits.y)) * color;
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    hit_sphere(ray, vec3(0.0, ball, 0.0), ball, BALL, hit);
    hit_spheres(ray, FIELD, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == BALL) return mirror(vec3(0.95));
    if (hit.object == FIELD) return matte(color_of(hit.item));
    return matte(vec3(0.5, 0.45, 0.4));
}
