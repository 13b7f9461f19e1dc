#include "shape/interval.glsl"

// A box along the axes, with the distances `half_size` from its centre to its faces. It is seen from outside and from inside.
void hit_box(Ray ray, vec3 centre, vec3 half_size, int object, INOUT(Hit) hit) {
    vec3 to_centre = centre - ray.origin;
    float middle = dot(to_centre, ray.direction);
    vec3 near = middle * ray.direction - to_centre;
    Interval x = interval_slab(near.x, ray.direction.x, half_size.x, vec3(1.0, 0.0, 0.0));
    Interval y = interval_slab(near.y, ray.direction.y, half_size.y, vec3(0.0, 1.0, 0.0));
    Interval z = interval_slab(near.z, ray.direction.z, half_size.z, vec3(0.0, 0.0, 1.0));
    hit_interval(interval_both(x, interval_both(y, z)), middle, object, hit);
}
