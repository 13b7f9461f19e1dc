#include "shape/interval.glsl"

// An ellipsoid with its three radii along the axes; seen from outside or inside. A unit sphere in the space scaled by them.
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
