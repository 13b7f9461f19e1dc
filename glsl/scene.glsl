// The words that a scene, the materials and the passes share. A scene defines
//
//     void scene_intersect(Ray ray, INOUT(Hit) hit)    nearest hit, by hit_sphere(), hit_plane() ... from shape/
//     Material scene_material(Hit hit)                 what is there, by matte(), mirror() ... from material/
//
// World: metres, right-handed, y up.
#include "math/dialect.glsl"

struct Ray {
    vec3 origin;
    vec3 direction; // unit length
};

// A shape's function hit_NAME() takes the nearest hit so far and replaces it by its own if that is nearer.
struct Hit {
    float t;       // distance along the ray, m; INFINITY is no hit
    vec3 position; // filled by the path tracer before scene_material()
    vec3 normal;   // unit length; faces the ray's origin by the time scene_material() sees it
    int object;    // the number that the scene gave to the shape
    int item;      // of an object of many shapes, such as hit_spheres()'s: which of them, from 0; else of no meaning
    bool inside;   // whether the ray came from within the solid, by the shape's own normal, which points out of it
};

// Made by material_new(), so that a member more changes no other material.
struct Material {
    int kind;          // MATERIAL_NAME of the file material/name.glsl
    vec3 color;        // albedo, or tint of a mirror
    float roughness;   // 0 to 1
    float reflectance; // share of the light that is reflected as by a mirror, 0 to 1
    float ior;         // index of refraction within the solid over that around it; at a hit, beyond the surface over before it
};

// Where a path goes on, and what it is worth: f cos / pdf.
struct Bounce {
    vec3 direction;
    vec3 weight;
    float pdf;    // by solid angle, 1/sr; 0 where the direction was the only one, as on a mirror
    bool lambert; // whether it was drawn by Lambert's cosine, with the albedo as weight
};

Hit hit_none() {
    return Hit(INFINITY, vec3(0.0), vec3(0.0), -1, 0, false);
}

Material material_new(int kind, vec3 color) {
    return Material(kind, color, 1.0, 0.0, 1.0);
}

// The ray that leaves a hit. Its origin is lifted off the surface to the side that it goes to, by a step in proportion to the
// coordinates that the hit was computed from: 32 float roundings, of which the hit itself has a few. What grazes the surface
// by no more than roundings stays on the side that it came from.
Ray ray_from(Hit hit, vec3 direction) {
    vec3 size = abs(hit.position);
    float lift = 2.0e-6 * (max(max(size.x, size.y), size.z) + hit.t);
    float side = dot(direction, hit.normal) < -1.0e-5 ? -lift : lift;
    return Ray(hit.position + side * hit.normal, direction);
}
