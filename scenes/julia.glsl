//@ title   Quaternion Julia set
//@ look    "a fractal in four dimensions, cut by our space: shells that curl into each other, in colours by the orbit"
//@ camera  eye 1.7 2.1 -2.9  target 0 0.95 0  fov 45
//@ sun     elevation 30  azimuth 130
//@ atmosphere earth
//@ size    512 512
//@ bound   0 1.1 0 1.5
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4
#include "distance/julia.glsl"
#include "material/matte.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"

uniform float c_real;    //@ slider -0.2  min -1  max 0.5  label "of c, the real part"
uniform float c_i;       //@ slider 0.6   min -1  max 1  label "of c, along i"
uniform float c_j;       //@ slider 0.2   min -1  max 1  label "of c, along j"
uniform float c_k;       //@ slider 0.2   min -1  max 1  label "of c, along k"
uniform float iterations;  //@ slider 9  min 2  max 14  label "how fine"

const int GROUND = 0;
const int SET = 1;
const vec3 MIDDLE = vec3(0.0, 1.1, 0.0);

float scene_distance(vec3 p) {
    return distance_julia(p - MIDDLE, vec4(c_real, c_i, c_j, c_k), int(iterations + 0.5));
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    march(ray, MIDDLE, 1.5, SET, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == GROUND) return matte(vec3(0.45));
    vec4 trap = vec4(0.0);
    distance_julia(hit.position - MIDDLE, vec4(c_real, c_i, c_j, c_k), int(iterations + 0.5), trap);
    vec3 color = mix(vec3(0.2, 0.4, 0.6), vec3(0.85, 0.75, 0.5), clamp(2.0 * sqrt(trap.w) - 0.2, 0.0, 1.0));
    return matte(mix(vec3(0.7, 0.25, 0.15), color, clamp(6.0 * trap.x, 0.0, 1.0)));
}
