#include "shape/search.glsl"
#include "shape/sphere.glsl"

// The scene's many spheres (`//@ spheres`), of which a ray is tested against some tens, whatever their number. hit.item is the
// number of the sphere that was hit: the i of scene_sphere(i), or the file's row, from 0.
//
// They lie in a tree of boxes in boxes, written as a list that is read in one direction (src/scene/sphere_tree.h): an entry is a
// box, or a sphere; behind a box comes what it holds, and a ray that misses the box skips that. No stack is needed. To meet the
// near half of a box before the far one, there are eight lists, one for each octant of directions; with that octant's near and
// far corners of boxes, so that entering and leaving need no ordering.
//
// An entry is two texels. Box: near corner and 0; far corner and how many entries to skip when it is missed. Sphere: centre and
// radius; its number, 0, 0, 0.
vec4 spheres_texel(int i);
int spheres_entries(); // of one list

// One ray looks at SPHERES_STEPS entries at most: twenty to seventy are usual, of 100,000 spheres with little overlap a thousand
// are the most.
const int SPHERES_STEPS = 4096;
const float SPHERES_LEAST = 1.0e-20; // of a direction's component: dividing by it overflows nothing, and 0 / 0 is not met
const float SPHERES_ROUND = 1.0000006; // what float may round away between entering and leaving (Ize 2013)

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
