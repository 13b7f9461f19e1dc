// The structures that scenes, materials and passes share. A scene defines two functions:
//
//     void scene_intersect(Ray ray, INOUT(Hit) hit)    finds the nearest hit, with hit_sphere(), hit_plane() ... from shape/
//     Material scene_material(Hit hit)                 says what is there, with matte(), mirror() ... from material/
//
// Coordinates are metres in a right-handed frame, and y points up.
#include "math/dialect.glsl"

struct Ray {
    vec3 origin;
    // The direction has unit length.
    vec3 direction;
};

// A place where a ray meets a surface. A shape's function hit_NAME() gets the nearest hit so far, and replaces it if the shape is nearer.
struct Hit {
    // Distance along the ray in metres. INFINITY means that there is no hit.
    float t;
    // The path tracer sets the position before it calls scene_material().
    vec3 position;
    // The normal has unit length. When scene_material() gets it, it faces the ray's origin.
    vec3 normal;
    // The number that the scene gave to the shape.
    int object;
    // If the object consists of many shapes, as that of hit_spheres() does, this is the number of the shape, from 0. Otherwise it has no meaning.
    int item;
    // Says whether the ray came from within the solid. The shape's own normal, which points out of the solid, decides it.
    bool inside;
};

// Materials are made by material_new(). A new member of this structure then changes no other material.
struct Material {
    // MATERIAL_NAME of the file material/name.glsl.
    int kind;
    // The albedo, or the tint of a mirror.
    vec3 color;
    // From 0 to 1.
    float roughness;
    // The share of the light that is reflected as by a mirror, from 0 to 1.
    float reflectance;
    // Ratio of the indices of refraction, n_inside / n_outside. surface_material() turns it into n_transmitted / n_incident for the ray at hand.
    float ior;
};

// The direction in which a path goes on.
struct Bounce {
    vec3 direction;
    // f cos / pdf, where f is the BRDF and cos is the cosine between the direction and the normal.
    vec3 weight;
    // The density by solid angle, 1/sr. It is 0 if only one direction is possible, as on a mirror.
    float pdf;
    // Says whether the direction was drawn by Lambert's cosine, so that the weight is the albedo.
    bool lambert;
};

Hit hit_none() {
    return Hit(INFINITY, vec3(0.0), vec3(0.0), -1, 0, false);
}

Material material_new(int kind, vec3 color) {
    return Material(kind, color, 1.0, 0.0, 1.0);
}

// Returns the ray that leaves a hit in a direction. Its origin is lifted off the surface, to the side that the ray goes to.
// The lift is proportional to the coordinates that the hit was computed from. It is 32 float roundings; the hit itself has an error of a few.
// A ray that is parallel to the surface up to roundings stays on the side that it came from.
Ray ray_from(Hit hit, vec3 direction) {
    vec3 size = abs(hit.position);
    float lift = 2.0e-6 * (max(max(size.x, size.y), size.z) + hit.t);
    float sink = -lift;
    float side = dot(direction, hit.normal) < -1.0e-5 ? sink : lift;
    return Ray(hit.position + side * hit.normal, direction);
}

// What a path tells the searches of its next ray. Rays that nobody speaks of, such as those of the camera and those toward lamps and the sun, have the values
// below.

// Half the angle in which the rays of similar paths lie, in radians, from 0 to 1. What such a ray finds is averaged over the whole cone.
float ray_spread = 0.0;
// The object whose outer side the ray leaves, or -1. The ray cannot begin within this object.
int ray_leaves = -1;
