#include "scene.glsl"

// The plane of the points p with dot(normal, p) = offset. `normal` has unit length. The plane is seen from both sides.
void hit_plane(Ray ray, vec3 normal, float offset, int object, INOUT(Hit) hit) {
    float height = dot(normal, ray.origin) - offset;
    float descent = -dot(normal, ray.direction);
    float t = height / descent;
    if (height * descent > 0.0 && t < hit.t) {
        hit.t = t;
        hit.normal = normal;
        hit.object = object;
    }
}
