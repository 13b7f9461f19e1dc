#include "scene.glsl"

// How far along the ray a sphere is met, seen from outside or inside; INFINITY where it is not. The discriminant is taken from
// the ray's closest approach to the centre, which loses nothing to cancellation when the sphere is far away or small (Haines et
// al., Ray Tracing Gems 7).
float sphere_along(vec3 to_centre, vec3 direction, float radius) {
    float middle = dot(to_centre, direction);
    vec3 miss = to_centre - middle * direction;
    float discriminant = radius * radius - dot(miss, miss);
    float half_chord = sqrt(max(discriminant, 0.0));
    float t = middle > half_chord ? middle - half_chord : middle + half_chord;
    return discriminant > 0.0 && t > 0.0 ? t : INFINITY;
}

void hit_sphere(Ray ray, vec3 centre, float radius, int object, INOUT(Hit) hit) {
    vec3 to_centre = centre - ray.origin;
    float t = sphere_along(to_centre, ray.direction, radius);
    if (t < hit.t) {
        hit.t = t;
        hit.normal = normalize(t * ray.direction - to_centre);
        hit.object = object;
    }
}
