#include "shape/interval.glsl"

// An ellipsoid with three radii along the axes. It is seen from outside and from inside. The ray is divided by the radii, and meets a
// unit sphere.
void hit_ellipsoid(Ray ray, vec3 centre, vec3 radii, int object, INOUT(Hit) hit) {
    vec3 to_centre = centre - ray.origin;
    float middle = dot(to_centre, ray.direction);
    vec3 near = (middle * ray.direction - to_centre) / radii;
    vec3 direction = ray.direction / radii;
    float speed = dot(direction, direction);
    float closest = -dot(near, direction) / speed;
    vec3 miss = near + closest * direction;
    float discriminant = 1.0 - dot(miss, miss);
    if (discriminant > 0.0) {
        float half_chord = sqrt(discriminant / speed);
        Interval inside = Interval(closest - half_chord, closest + half_chord, (miss - half_chord * direction) / radii,
                                   (miss + half_chord * direction) / radii);
        hit_interval(inside, middle, object, hit);
    }
}
