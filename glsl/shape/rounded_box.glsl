#include "shape/interval.glsl"

// Returns where a ray that comes from outside meets a rounded box about the origin, starting at t. Returns INFINITY if it misses the box.
// The distance to a convex solid is a convex function along a ray, so Newton's steps from outside never pass the surface.
float rounded_box_meet(vec3 origin, vec3 direction, vec3 core, float radius, float t) {
    float gap = 0.0;
    float fall = 1.0;
    for (int i = 0; i < 20; i++) {
        vec3 p = origin + t * direction;
        vec3 q = max(abs(p) - core, vec3(0.0));
        float reach = length(q);
        gap = reach - radius;
        fall = -dot(sign(p) * q, direction) / max(reach, 1.0e-30);
        if (gap <= 1.2e-7 * reach || fall <= 0.0) break;
        t += gap / fall;
    }
    return gap < 1.0e-6 * radius || fall > 0.0 ? t : INFINITY;
}

vec3 rounded_box_normal(vec3 p, vec3 core) {
    return sign(p) * max(abs(p) - core, vec3(0.0));
}

// A box along the axes, with the distances `half_size` from its centre to its faces, and edges rounded by `radius`. The radius is above 0 and
// not more than the smallest half size. The box is seen from outside and from inside.
void hit_rounded_box(Ray ray, vec3 centre, vec3 half_size, float radius, int object, INOUT(Hit) hit) {
    vec3 to_centre = centre - ray.origin;
    float middle = dot(to_centre, ray.direction);
    vec3 near = middle * ray.direction - to_centre;
    vec3 core = half_size - radius;
    Interval x = interval_slab(near.x, ray.direction.x, half_size.x, vec3(1.0, 0.0, 0.0));
    Interval y = interval_slab(near.y, ray.direction.y, half_size.y, vec3(0.0, 1.0, 0.0));
    Interval z = interval_slab(near.z, ray.direction.z, half_size.z, vec3(0.0, 0.0, 1.0));
    Interval box = interval_both(x, interval_both(y, z));
    if (box.enter < box.leave) {
        box.enter = rounded_box_meet(near, ray.direction, core, radius, box.enter);
        box.leave = -rounded_box_meet(near, -ray.direction, core, radius, -box.leave);
        box.enter_normal = rounded_box_normal(near + box.enter * ray.direction, core);
        box.leave_normal = rounded_box_normal(near + box.leave * ray.direction, core);
        hit_interval(box, middle, object, hit);
    }
}
