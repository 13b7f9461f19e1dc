//@ title   Solids that share their colours
//@ look    "colours flow just where the shapes do; a boulder of noise, painted from three sides; strata that bend with their block"
//@ camera  eye 0.3 2.9 -5.2  target 0 0.6 0  fov 40
//@ sun     elevation 30  azimuth 130
//@ atmosphere earth
//@ size    512 512
//@ bound   0 0.7 0  2.2
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4

// Seen from the camera, from left to right: a block in warped space, a post, a ring and a ball that flow into each other, and a boulder.
#include "color/triplanar.glsl"
#include "distance/box.glsl"
#include "distance/capsule.glsl"
#include "distance/noise.glsl"
#include "distance/share.glsl"
#include "distance/smooth.glsl"
#include "distance/sphere.glsl"
#include "distance/torus.glsl"
#include "material/matte.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"

uniform float k;       //@ slider 0.35  min 0  max 0.6  unit m  label "how far surfaces and colours flow"
uniform float rough;   //@ slider 0.4   min 0  max 0.8  unit m  label "how high the boulder's noise is"
uniform float crooked; //@ slider 0.1   min 0  max 0.15  unit m  label "how far the block is warped"

const int GROUND = 0;
const int SOLID = 1;
const float CROOKED_SPACING = 0.6;

// The solids, which begin with the colour that they have where they are met.
float flowing(vec3 p, OUT(vec3) color) {
    float post = distance_capsule(p, vec3(0.0, 0.25, 0.0), vec3(0.0, 1.0, 0.0), 0.2);
    float ring = distance_torus(p, vec3(0.0, 0.2, 0.0), vec3(0.0, 1.0, 0.0), 0.5, 0.2);
    float ball = distance_sphere(p, vec3(0.0, 1.35, 0.0), 0.35);
    float foot = op_smooth_union(post, ring, k);
    color = mix(vec3(0.75, 0.62, 0.2), vec3(0.12, 0.35, 0.6), share_smooth_union(post, ring, k));
    color = mix(color, vec3(0.72, 0.16, 0.1), share_smooth_union(foot, ball, k));
    return op_smooth_union(foot, ball, k);
}

float boulder(vec3 p) {
    return op_noise_octaves(distance_sphere(p, vec3(-1.5, 0.5, 0.1), 0.35), p, rough, 0.5, 4);
}

float block(vec3 p) {
    vec3 q = op_warp(p, crooked, CROOKED_SPACING);
    return distance_box(q, vec3(1.5, 0.5, 0.1), vec3(0.4, 0.55, 0.4)) / op_warp_steepness(crooked, CROOKED_SPACING);
}

float scene_distance(vec3 p) {
    vec3 color = vec3(0.0);
    return min(min(flowing(p, color), boulder(p)), block(p));
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    march(ray, vec3(0.0, 0.7, 0.0), 2.4, SOLID, hit);
}

// Stone with dark veins, drawn on three planes.
vec3 stone(vec3 p, vec3 normal) {
    vec3 share = triplanar(normal, 4.0);
    float vein = share.x * noise(vec3(8.0 * p.z, 2.0 * p.y, 0.5)) + share.y * noise(vec3(8.0 * p.z, 2.0 * p.x, 1.5)) +
                 share.z * noise(vec3(8.0 * p.x, 2.0 * p.y, 2.5));
    return mix(vec3(0.22, 0.2, 0.18), vec3(0.62, 0.58, 0.5), smoothstep(0.25, 0.6, vein));
}

vec3 strata(vec3 p) {
    float height = op_warp(p, crooked, CROOKED_SPACING).y;
    return mix(vec3(0.7, 0.42, 0.25), vec3(0.85, 0.75, 0.6), step(0.5, fract(6.0 * height)));
}

Material scene_material(Hit hit) {
    if (hit.object == GROUND) return matte(vec3(0.45));
    vec3 color = vec3(0.0);
    float flow = flowing(hit.position, color);
    color = mix(color, stone(hit.position, hit.normal), share_union(flow, boulder(hit.position)));
    return matte(mix(color, strata(hit.position), share_union(min(flow, boulder(hit.position)), block(hit.position))));
}
