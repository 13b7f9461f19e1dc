#include "distance/section.glsl"

// Parts of balls. `axis` has unit length, and the distances are exact.

// A slice of pie: the part of a ball about `tip` within half_angle radians of the axis. half_angle is less than PI.
float distance_solid_angle(vec3 p, vec3 tip, vec3 axis, float half_angle, float radius) {
    vec2 q = op_revolve(p, tip, axis);
    vec2 edge = vec2(sin(half_angle), cos(half_angle));
    float to_cone = length(q - edge * clamp(dot(q, edge), 0.0, radius));
    float side = q.x * edge.y > q.y * edge.x ? 1.0 : -1.0;
    return max(length(q) - radius, side * to_cone);
}

// The part of a ball that lies less than `height` along the axis from its centre. `height` is between -radius and radius.
float distance_cut_sphere(vec3 p, vec3 centre, vec3 axis, float radius, float height) {
    vec2 q = op_revolve(p, centre, axis);
    vec2 rim = vec2(sqrt(max(radius * radius - height * height, 0.0)), height);
    float to_rim = length(q - rim);
    float from_centre = length(q);
    float to_ball = abs(from_centre - radius);
    // The ball is nearest straight out from its centre, if it is not cut away there.
    float to_round = q.y * radius < height * from_centre ? to_ball : to_rim;
    float to_cut = length(vec2(max(q.x - rim.x, 0.0), q.y - height));
    bool inside = from_centre < radius && q.y < height;
    return (inside ? -1.0 : 1.0) * min(to_round, to_cut);
}

// A bowl: the round surface of distance_cut_sphere(), as a shell with a round rim. Half of `thickness` is on each side of the surface.
float distance_cut_hollow_sphere(vec3 p, vec3 centre, vec3 axis, float radius, float height, float thickness) {
    vec2 q = op_revolve(p, centre, axis);
    vec2 rim = vec2(sqrt(max(radius * radius - height * height, 0.0)), height);
    float to_rim = length(q - rim);
    float from_centre = length(q);
    float to_ball = abs(from_centre - radius);
    return (q.y * radius < height * from_centre ? to_ball : to_rim) - 0.5 * thickness;
}
