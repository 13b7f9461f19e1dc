//@ title   Two mirrors
//@ look    "the figure between two mirrors, again and again, each time darker and greener; a bent row where the tilt is not 0"
//@ camera  eye 0.7 1.3 -1.35  target -0.15 0.8 1.6  fov 60
//@ sun     elevation 40  azimuth 100
//@ atmosphere earth
//@ size    512 512
//@ mirror-plane  0 0
//@ mirror-plane  -tilt 0
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5   exposure 0.5
//@ preset  twilight  sun.elevation -2  exposure 4
#include "color/checker.glsl"
#include "material/matte.glsl"
#include "material/mirror.glsl"
#include "shape/box.glsl"
#include "shape/cone.glsl"
#include "shape/plane.glsl"
#include "shape/sphere.glsl"

uniform float distance_m; //@ slider 3.2  min 1  max 6  unit m  label "between the mirrors"
uniform float tilt;       //@ slider 2  min 0  max 10  unit deg  label "of the far mirror"
uniform vec3 tint;        //@ color 0.9 0.95 0.91  label "what the mirrors reflect"

const int GROUND = 0;
const int MIRROR = 1;
const int FRAME = 2;
const int BODY = 3;
const int HEAD = 4;

// A mirror is a box in a frame that is a little thinner. The box's narrow sides are wood. The far mirror and its frame lie in a space that is
// turned about the vertical.
void hit_framed(Ray ray, vec3 centre, INOUT(Hit) hit) {
    Hit pane = hit;
    hit_box(ray, centre, vec3(1.2, 0.75, 0.03), MIRROR, pane);
    if (pane.t < hit.t) {
        pane.object = abs(pane.normal.z) > 0.5 ? MIRROR : FRAME;
        hit = pane;
    }
    hit_box(ray, centre, vec3(1.26, 0.81, 0.02), FRAME, hit);
}

vec3 turned(vec3 v, float angle) {
    return vec3(cos(angle) * v.x + sin(angle) * v.z, v.y, cos(angle) * v.z - sin(angle) * v.x);
}

// What may block the sky: a ball around each mirror, and one around the figure.
const int SCENE_BOUNDS = 3;
vec4 scene_bound(int i) {
    if (i == 0) return vec4(0.0, 0.9, -0.5 * distance_m, 1.4);
    if (i == 1) return vec4(0.0, 0.9, 0.5 * distance_m, 1.4);
    return vec4(0.0, 0.6, 0.0, 0.6);
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    float angle = radians(tilt);
    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, GROUND, hit);
    hit_framed(ray, vec3(0.0, 0.9, -0.5 * distance_m), hit);
    hit_cone(ray, vec3(0.0), vec3(0.0, 1.0, 0.0), 0.3, BODY, hit);
    hit_sphere(ray, vec3(0.0, 1.0, 0.0), 0.17, HEAD, hit);
    Hit far = hit;
    hit_framed(Ray(turned(ray.origin, angle), turned(ray.direction, angle)), vec3(0.0, 0.9, 0.5 * distance_m), far);
    if (far.t < hit.t) {
        far.normal = turned(far.normal, -angle);
        hit = far;
    }
}

Material scene_material(Hit hit) {
    if (hit.object == MIRROR) return mirror(tint);
    if (hit.object == FRAME) return matte(vec3(0.3, 0.2, 0.12));
    if (hit.object == BODY) return matte(vec3(0.7, 0.18, 0.12));
    if (hit.object == HEAD) return matte(vec3(0.8, 0.65, 0.5));
    return matte(checker(2.0 * hit.position, vec3(0.65), vec3(0.3)));
}
