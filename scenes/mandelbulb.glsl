//@ title   Mandelbulb
//@ look    "a fractal of a power in space: buds around a bulb, and buds around these, in colours by the orbit"
//@ camera  eye 1.5 2.2 -2.8  target 0 1.12 0  fov 45
//@ sun     elevation 30  azimuth 130
//@ atmosphere earth
//@ size    512 512
//@ bound   0 1.2 0 1.3
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4
#include "distance/mandelbulb.glsl"
#include "distance/move.glsl"
#include "distance/offset.glsl"
#include "material/matte.glsl"
#include "shape/march.glsl"
#include "shape/plane.glsl"

uniform float power;       //@ slider 8       min 5      max 12     label "to which places are raised"
uniform float iterations;  //@ slider 5       min 2      max 8      label "how fine"
uniform float rounding;    //@ slider 0.0015  min 0.001  max 0.005  label "what is finer is rounded"

const int GROUND = 0;
const int BULB = 1;
const vec3 MIDDLE = vec3(0.0, 1.2, 0.0);

// The bulb leans toward the camera.
vec3 bulb_place(vec3 p) {
    return op_rotate(p - MIDDLE, vec3(0.8, 0.0, 0.6), -0.6);
}

// The Mandelbulb has detail of every size, down to what no march can follow, and inside its field is steep. The rounding hides what is finer than a
// pixel of the picture, and it puts the surface where the field is a distance. Within the bulb the field is 0 less the rounding.
float scene_distance(vec3 p) {
    float bulb = distance_mandelbulb(bulb_place(p), floor(power + 0.5), int(iterations + 0.5));
    return op_round(max(bulb, 0.0), rounding);
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    march(ray, MIDDLE, 1.3, BULB, hit);
}

Material scene_material(Hit hit) {
    if (hit.object == GROUND) return matte(vec3(0.45));
    vec4 trap = vec4(0.0);
    distance_mandelbulb(bulb_place(hit.position), floor(power + 0.5), int(iterations + 0.5), trap);
    vec3 color = mix(vec3(0.6, 0.15, 0.08), vec3(0.85, 0.62, 0.3), clamp(3.0 * sqrt(trap.w) - 2.0, 0.0, 1.0));
    return matte(mix(vec3(0.2, 0.35, 0.5), color, clamp(8.0 * trap.y, 0.0, 1.0)));
}
