#include "scene.glsl"

// A flat disk about `centre`. `normal` has unit length. The disk is seen from both sides.
void hit_disk(Ray ray, vec3 centre, vec3 normal, float radius, int object, INOUT(Hit) hit) {
    vec3 to_centre = centre - ray.origin;
    float t = dot(normal, to_centre) / dot(normal, ray.direction);
    vec3 from_centre = t * ray.direction - to_centre;
    if (t > 0.0 && t < hit.t && dot(from_centre, from_centre) <= radius * radius) {
        hit.t = t;
        hit.normal = normal;
        hit.object = object;
    }
}
