#include "shape/interval.glsl"

// The solid of all points within `radius` of the line from `end` to `other_end`. It is seen from outside and from inside.
void hit_capsule(Ray ray, vec3 end, vec3 other_end, float radius, int object, INOUT(Hit) hit) {
    vec3 to_centre = 0.5 * (end + other_end) - ray.origin;
    float middle = dot(to_centre, ray.direction);
    vec3 near = middle * ray.direction - to_centre;
    float height = length(other_end - end);
    vec3 axis = (other_end - end) / height;
    Interval side = interval_cylinder(-near, ray.direction, axis, radius);
    Interval ends = interval_slab(dot(near, axis), dot(ray.direction, axis), 0.5 * height, axis);
    Interval ball = interval_sphere(-0.5 * height * axis - near, ray.direction, radius);
    Interval other_ball = interval_sphere(0.5 * height * axis - near, ray.direction, radius);
    Interval balls = interval_either(ball, other_ball);
    hit_interval(interval_either(balls, interval_both(side, ends)), middle, object, hit);
}
