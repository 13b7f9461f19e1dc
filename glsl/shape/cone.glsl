#include "shape/interval.glsl"

// Returns the part of a ray in a cone that goes on for ever from its tip along `axis`. Its radius grows by `spread` a metre.
// `from_tip` leads from the tip to the ray's origin. `direction` and `axis` have unit length.
Interval interval_cone(vec3 from_tip, vec3 direction, vec3 axis, float spread) {
    float height = dot(from_tip, axis);
    float climb = dot(direction, axis);
    vec3 from_axis = from_tip - height * axis;
    vec3 across = direction - climb * axis;
    // a t^2 + 2 b t + c <= 0 holds in the cone, and in its mirror image beyond the tip.
    float a = dot(across, across) - spread * spread * climb * climb;
    float b = dot(from_axis, across) - spread * spread * height * climb;
    float c = dot(from_axis, from_axis) - spread * spread * height * height;
    float discriminant = b * b - a * c;
    float root = sqrt(max(discriminant, 0.0));
    float lower = -b - root;
    float upper = -b + root;
    float sum = b >= 0.0 ? lower : upper;
    float one = sum / (abs(a) > 1.0e-20 ? a : 1.0e-20);
    float quotient = c / sum;
    float other = sum != 0.0 ? quotient : 0.0;
    float first = clamp(min(one, other), -1.0e20, 1.0e20);
    float last = clamp(max(one, other), -1.0e20, 1.0e20);
    // Where the ray is so steep that it stays in the cone, or comes from the mirror image.
    float steep_enter = climb > 0.0 ? last : -1.0e20;
    float steep_leave = climb > 0.0 ? 1.0e20 : first;
    float enter = a > 0.0 ? first : steep_enter;
    float leave = a > 0.0 ? last : steep_leave;
    vec3 at_enter = from_axis + enter * across;
    vec3 at_leave = from_axis + leave * across;
    Interval inside =
        Interval(enter, leave, at_enter - spread * length(at_enter) * axis, at_leave - spread * length(at_leave) * axis);
    return interval_if(discriminant >= 0.0 || a <= 0.0, inside);
}

// A solid cone from the middle of its base to its tip, with `radius` at the base. It is seen from outside and from inside.
// Everything is counted from the ray's closest approach to the tip, where the cone is thin and needs small numbers.
void hit_cone(Ray ray, vec3 base, vec3 tip, float radius, int object, INOUT(Hit) hit) {
    vec3 to_tip = tip - ray.origin;
    float middle = dot(to_tip, ray.direction);
    vec3 near = middle * ray.direction - to_tip;
    float height = length(base - tip);
    vec3 axis = (base - tip) / height;
    Interval side = interval_cone(near, ray.direction, axis, radius / height);
    Interval ends = interval_slab(dot(near, axis) - 0.5 * height, dot(ray.direction, axis), 0.5 * height, axis);
    hit_interval(interval_both(side, ends), middle, object, hit);
}
