//@ title   The author's room
//@ look    "the hollow of the back wall, which mirrors half of what it gets: the balls, the sky, and two lamps from beside the camera"
//@ camera  eye 0 2 -4  target 0 0 0  fov 90
//@ sun     elevation 60  azimuth 160
//@ size    512 512
//@ exposure -2
//@ emitter-sphere  -3 3 -3  1
//@ emitter-sphere   3 3 -3  1
//@ mirror-sphere  1.5 0 0  0.5
//@ preset  noon      sun.elevation 60
//@ preset  sunset    sun.elevation 5
//@ preset  twilight  sun.elevation -2
//@ preset  daylight  radiance 0  exposure 1

// The room of the paper's author, with his materials. It is open above and behind the camera. The coordinates are his; his picture is mirrored.
//
// The empty space is a union of convex parts, and each part is an interval of a ray: the room, the space behind the ends of its walls, the space
// above them, and the ball that is taken out of the back wall and the floor.
#include "material/author.glsl"
#include "material/emitter.glsl"
#include "material/mirror.glsl"
#include "shape/interval.glsl"
#include "shape/sphere.glsl"

uniform float radiance; //@ slider 16  max 100  label "of the lamps"
uniform float hollow;   //@ slider 2  min 1.6  max 2.5  unit m  label "radius of the ball taken out of the wall"

const int WALLS = 0;
const int ENDS = 1;
const int HOLLOW = 2;
const int LAMPS = 3;
const int MIRROR = 4;
const int GLOSSY = 5;
const int MATTE = 6;
const int RED = 7;
const int GREEN = 8;
const int BLUE = 9;
const int YELLOW = 10;
const int CYAN = 11;
const int MAGENTA = 12;

// Returns the part of the ray beyond a plane, on the side that `normal` points to.
Interval beyond(Ray ray, vec3 normal, float offset) {
    float height = dot(normal, ray.origin) - offset;
    float slope = dot(normal, ray.direction);
    float t = -height / (abs(slope) > 1.0e-20 ? slope : 1.0e-20);
    bool leaves = slope >= 0.0;
    vec3 opposite = -normal;
    return Interval(leaves ? t : -INFINITY, leaves ? INFINITY : t, leaves ? opposite : normal, leaves ? normal : opposite);
}

// Moves the ray's end through a part of the empty space, if the end is in that part.
void pass_through(Interval part, int object, INOUT(Hit) wall) {
    if (part.enter <= wall.t + 1.0e-5 && part.leave > wall.t) {
        wall.t = part.leave;
        wall.normal = -part.leave_normal;
        wall.object = object;
    }
}

void hit_walls(Ray ray, INOUT(Hit) hit) {
    vec3 x = vec3(1.0, 0.0, 0.0);
    vec3 y = vec3(0.0, 1.0, 0.0);
    vec3 z = vec3(0.0, 0.0, 1.0);
    Interval across = interval_both(beyond(ray, x, -3.25), beyond(ray, -x, -3.25));
    Interval room = interval_both(across, interval_both(beyond(ray, y, -0.5), beyond(ray, -z, -1.5)));
    Interval ball = interval_sphere(vec3(0.0, 0.5, 1.0) - ray.origin, ray.direction, hollow);
    Interval behind = beyond(ray, -z, 4.0);
    Interval above = beyond(ray, y, 4.0);
    Hit wall = hit_none();
    wall.t = 0.0;
    // The parts are convex, so a ray comes to each of them once.
    for (int i = 0; i < 3; i++) {
        pass_through(behind, ENDS, wall);
        pass_through(room, WALLS, wall);
        pass_through(ball, HOLLOW, wall);
        pass_through(above, ENDS, wall);
    }
    if (wall.t > 0.0 && wall.t < hit.t) hit = wall;
}

void scene_intersect(Ray ray, INOUT(Hit) hit) {
    hit_walls(ray, hit);
    hit_sphere(ray, vec3(-3.0, 3.0, -3.0), 1.0, LAMPS, hit);
    hit_sphere(ray, vec3(3.0, 3.0, -3.0), 1.0, LAMPS, hit);
    hit_sphere(ray, vec3(1.5, 0.0, 0.0), 0.5, MIRROR, hit);
    hit_sphere(ray, vec3(0.0, 0.0, 0.25), 0.5, GLOSSY, hit);
    hit_sphere(ray, vec3(-1.5, 0.0, 0.0), 0.5, MATTE, hit);
    hit_sphere(ray, vec3(-1.0, -0.25, -0.85), 0.25, RED, hit);
    hit_sphere(ray, vec3(0.0, -0.25, -1.0), 0.25, GREEN, hit);
    hit_sphere(ray, vec3(1.0, -0.25, -0.85), 0.25, BLUE, hit);
    hit_sphere(ray, vec3(0.8, 0.5, 0.5), 0.25, YELLOW, hit);
    hit_sphere(ray, vec3(-0.8, 0.5, 0.5), 0.25, CYAN, hit);
    hit_sphere(ray, vec3(0.0, 0.75, 0.7), 0.25, MAGENTA, hit);
}

const float ABSORBANCE = 0.1;

Material scene_material(Hit hit) {
    vec3 white = vec3(1.0);
    if (hit.object == LAMPS) return emitter(vec3(radiance));
    if (hit.object == MIRROR) return mirror(vec3(1.0 - ABSORBANCE));
    if (hit.object == HOLLOW) return author(white, 0.5, 0.0, ABSORBANCE);
    if (hit.object == GLOSSY) return author(white, 0.25, 0.0, ABSORBANCE);
    if (hit.object == RED) return author(vec3(1.0, 0.2, 0.2), 0.0, 1.0, ABSORBANCE);
    if (hit.object == GREEN) return author(vec3(0.2, 1.0, 0.2), 0.0, 1.0, ABSORBANCE);
    if (hit.object == BLUE) return author(vec3(0.2, 0.2, 1.0), 0.0, 1.0, ABSORBANCE);
    if (hit.object == YELLOW) return author(vec3(1.0, 1.0, 0.2), 0.5, 0.0, ABSORBANCE);
    if (hit.object == CYAN) return author(vec3(0.2, 1.0, 1.0), 0.5, 1.0, ABSORBANCE);
    if (hit.object == MAGENTA) return author(vec3(1.0, 0.2, 1.0), 0.5, 0.5, ABSORBANCE);
    if (hit.object == WALLS && hit.normal.x > 0.5) return author(vec3(0.2, 0.2, 1.0), 0.0, 1.0, ABSORBANCE);
    if (hit.object == WALLS && hit.normal.x < -0.5) return author(vec3(1.0, 0.2, 0.2), 0.0, 1.0, ABSORBANCE);
    return author(white, 0.0, 1.0, ABSORBANCE);
}
