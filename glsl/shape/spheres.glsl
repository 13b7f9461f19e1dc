#include "shape/search.glsl"
#include "shape/sphere.glsl"

// The many spheres of a scene (`//@ spheres`). A ray is tested against some tens of them, however many there are.
// hit.item is the number of the sphere that was hit, from 0: the i of scene_sphere(i), or the row of the file.
//
// The spheres lie in a tree of nested boxes. The tree is written as a list that is read in one direction (src/scene/sphere_tree.h). An entry of the
// list is a box or a sphere. The contents of a box follow it, and a ray that misses the box skips them, so no stack is needed.
// There are eight lists, one for each octant of directions, so that a ray meets the nearer half of a box first. The boxes of a list have their near
// and far corners as that octant sees them.
//
// An entry is two texels. Those of a box are (near corner, 0) and (far corner, number of entries to skip if the ray misses the box). Those of a
// sphere are (centre, radius) and (number, 0, 0, 0).
vec4 spheres_texel(int i);
// Returns the number of entries of one list.
int spheres_entries();

// One ray looks at up to SPHERES_STEPS entries. Twenty to seventy are usual. Among 100,000 spheres that overlap little, a thousand are the most.
const int SPHERES_STEPS = 4096;
// The least component of a direction. Dividing by it does not overflow, and 0 / 0 does not occur.
const float SPHERES_LEAST = 1.0e-20;
// Makes up for what float rounds away between entering and leaving a box (Ize 2013).
const float SPHERES_ROUND = 1.0000006;

float spheres_component(float v) {
    return abs(v) > SPHERES_LEAST ? v : SPHERES_LEAST;
}

void hit_spheres(Ray ray, int object, INOUT(Hit) hit) {
    vec3 d = vec3(spheres_component(ray.direction.x), spheres_component(ray.direction.y), spheres_component(ray.direction.z));
    vec3 inverse = 1.0 / d;
    int octant = (d.x < 0.0 ? 1 : 0) + (d.y < 0.0 ? 2 : 0) + (d.z < 0.0 ? 4 : 0);
    int entries = spheres_entries();
    int at = octant * entries;
    int end = at + entries;
    int last = search_steps + SPHERES_STEPS;
    int item = -1;
    vec4 nearest = vec4(0.0);
    float t = hit.t;
    search_rays += 1;
    while (at < end && search_steps < last) {
        vec4 a = spheres_texel(2 * at);
        vec4 b = spheres_texel(2 * at + 1);
        vec3 off = vec3(a) - ray.origin;
        bool sphere = b.w == 0.0;
        float along = 0.0;
        bool meets = sphere_meets(off, ray.direction, a.w, along);
        if (sphere && meets && along < t) {
            t = along;
            item = int(b.x);
            nearest = a;
        }
        vec3 enter = off * inverse;
        vec3 leave = (vec3(b) - ray.origin) * inverse;
        float left = SPHERES_ROUND * min(min(leave.x, leave.y), leave.z);
        bool open = left >= 0.0 && max(max(enter.x, enter.y), enter.z) <= min(left, t);
        at += sphere || open ? 1 : int(b.w);
        search_steps += 1;
    }
    if (at < end) search_cut += 1;
    if (item >= 0) {
        hit.t = t;
        hit.normal = normalize(t * ray.direction - (vec3(nearest) - ray.origin));
        hit.object = object;
        hit.item = item;
    }
}
