#include "scene.glsl"

// The part of a ray in a convex solid, and the solid's normals at both ends of this part.
// Intervals of simple solids are combined into those of others, so that no gap is left between the parts. interval_both() is the part in both
// of two solids. interval_either() is the part in one or the other; their union must be convex too.
struct Interval {
    // Where the ray enters the solid, in metres. It is larger than `leave` if the ray misses the solid.
    float enter;
    float leave;
    vec3 enter_normal;
    vec3 leave_normal;
};

Interval interval_none() {
    return Interval(INFINITY, -INFINITY, vec3(0.0), vec3(0.0));
}

// Returns the interval if the ray meets the solid, and interval_none() otherwise. It has one end, and its `?:` choose between names: see
// README.md, "What WebGL refuses". The normals of an interval that is none are not looked at.
Interval interval_if(bool meets, Interval interval) {
    interval.enter = meets ? interval.enter : INFINITY;
    interval.leave = meets ? interval.leave : -INFINITY;
    return interval;
}

Interval interval_both(Interval a, Interval b) {
    bool a_enters = a.enter >= b.enter;
    bool a_leaves = a.leave <= b.leave;
    Interval both = Interval(a_enters ? a.enter : b.enter, a_leaves ? a.leave : b.leave,
                             a_enters ? a.enter_normal : b.enter_normal, a_leaves ? a.leave_normal : b.leave_normal);
    return interval_if(both.enter < both.leave, both);
}

Interval interval_either(Interval a, Interval b) {
    bool a_enters = a.enter <= b.enter;
    bool a_leaves = a.leave >= b.leave;
    return Interval(a_enters ? a.enter : b.enter, a_leaves ? a.leave : b.leave,
                    a_enters ? a.enter_normal : b.enter_normal, a_leaves ? a.leave_normal : b.leave_normal);
}

// Returns the part of a ray between two planes, where |height + t slope| <= half_thickness. Height is measured along the unit vector `normal`.
Interval interval_slab(float height, float slope, float half_thickness, vec3 normal) {
    float inverse = 1.0e20;
    if (abs(slope) > 1.0e-20) inverse = 1.0 / slope;
    float low = (-half_thickness - height) * inverse;
    float high = (half_thickness - height) * inverse;
    vec3 opposite = -normal;
    vec3 onward = inverse >= 0.0 ? normal : opposite;
    vec3 backward = inverse >= 0.0 ? opposite : normal;
    return Interval(min(low, high), max(low, high), backward, onward);
}

// Returns the part of a ray in a sphere. `to_centre` leads from the ray's origin to the sphere's centre.
// The computation uses the ray's closest approach to the centre, as hit_sphere() does.
Interval interval_sphere(vec3 to_centre, vec3 direction, float radius) {
    float middle = dot(to_centre, direction);
    vec3 miss = to_centre - middle * direction;
    float discriminant = radius * radius - dot(miss, miss);
    float half_chord = sqrt(max(discriminant, 0.0));
    Interval inside = Interval(middle - half_chord, middle + half_chord, (-half_chord * direction - miss) / radius,
                               (half_chord * direction - miss) / radius);
    return interval_if(discriminant > 0.0, inside);
}

// Returns the part of a ray in an endless cylinder about an axis. `to_centre` leads from the ray's origin to a point of the axis, and `axis` has
// unit length.
Interval interval_cylinder(vec3 to_centre, vec3 direction, vec3 axis, float radius) {
    vec3 across = direction - dot(direction, axis) * axis;
    vec3 from_axis = dot(to_centre, axis) * axis - to_centre;
    float speed = max(dot(across, across), 1.0e-24);
    float middle = -dot(from_axis, across) / speed;
    vec3 miss = from_axis + middle * across;
    float discriminant = radius * radius - dot(miss, miss);
    float half_chord = sqrt(max(discriminant, 0.0) / speed);
    Interval inside = Interval(middle - half_chord, middle + half_chord, (miss - half_chord * across) / radius,
                               (miss + half_chord * across) / radius);
    return interval_if(discriminant > 0.0, inside);
}

// Replaces `hit` by the interval's nearest end ahead of the ray's origin, if that is nearer than `hit`.
// The interval is counted from `middle`. Shapes count from the ray's closest approach to their centre: numbers there are as small as the
// shape, however far away it is.
void hit_interval(Interval interval, float middle, int object, INOUT(Hit) hit) {
    bool outside = middle + interval.enter > 0.0;
    float t = middle + (outside ? interval.enter : interval.leave);
    if (interval.enter < interval.leave && t > 0.0 && t < hit.t) {
        hit.t = t;
        hit.normal = normalize(outside ? interval.enter_normal : interval.leave_normal);
        hit.object = object;
    }
}
