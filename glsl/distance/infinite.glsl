#include "distance/section.glsl"

// Solids without end. `axis` has unit length, and the distances are exact.

// The axis goes through `point`.
float distance_infinite_cylinder(vec3 p, vec3 point, vec3 axis, float radius) {
    return op_revolve(p, point, axis).x - radius;
}

// All directions from the tip within half_angle radians of the axis. half_angle is less than PI.
float distance_infinite_cone(vec3 p, vec3 tip, vec3 axis, float half_angle) {
    vec2 q = op_revolve(p, tip, axis);
    vec2 edge = vec2(sin(half_angle), cos(half_angle));
    float reach = length(q - edge * max(dot(q, edge), 0.0));
    return (q.x * edge.y < q.y * edge.x ? -1.0 : 1.0) * reach;
}
