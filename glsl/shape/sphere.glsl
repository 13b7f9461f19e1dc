#include "scene.glsl"

// A sphere, seen from outside or inside. The discriminant is taken from the ray's closest approach to the centre,
// which loses nothing to cancellation when the sphere is far away or small (Haines et al., Ray Tracing Gems 7).
void hit_sphere(Ray ray, vec3 centre, float radius, int object, INOUT(Hit) hit) {
    vec3 to_centre = centre - ray.origin;
    float middle = dot(to_centre, ray.direction);
    vec3 miss = to_centre - middle * ray.direction;
    float discriminant = radius * radius - dot(miss, miss);
    float half_chord = sqrt(max(discriminant, 0.0));
    float t = middle > half_chord ? middle - half_chord : middle + half_chord;
    if (discriminant > 0.0 && t > 0.0 && t < hit.t) {
        hit.t = t;
        hit.normal = normalize(t * ray.direction - to_centre);
        hit.object = object;
    }
}
