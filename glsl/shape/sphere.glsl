#include "scene.glsl"

// Says whether a ray meets a sphere, from outside or from inside, and sets t to the distance along the ray.
// The discriminant comes from the ray's closest approach to the centre. It loses no digits if the sphere is far away or small (Haines et
// al., Ray Tracing Gems, chapter 7).
bool sphere_meets(vec3 to_centre, vec3 direction, float radius, OUT(float) t) {
    float middle = dot(to_centre, direction);
    vec3 miss = to_centre - middle * direction;
    float discriminant = radius * radius - dot(miss, miss);
    float half_chord = sqrt(max(discriminant, 0.0));
    float enter = middle - half_chord;
    float leave = middle + half_chord;
    t = middle > half_chord ? enter : leave;
    return discriminant > 0.0 && t > 0.0;
}

void hit_sphere(Ray ray, vec3 centre, float radius, int object, INOUT(Hit) hit) {
    vec3 to_centre = centre - ray.origin;
    float t = 0.0;
    if (sphere_meets(to_centre, ray.direction, radius, t) && t < hit.t) {
        hit.t = t;
        hit.normal = normalize(t * ray.direction - to_centre);
        hit.object = object;
    }
}
