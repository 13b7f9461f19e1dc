#include "distance/polygon.glsl"
#include "distance/section.glsl"

// Prisms about the vertical axis y, from half_height below the centre to half_height above it. The distances are exact.

// `radius` reaches from the axis to the six corners, of which one points along z.
float distance_hexagonal_prism(vec3 p, vec3 centre, float radius, float half_height) {
    vec3 q = p - centre;
    return op_extrude(distance_regular_polygon(vec2(q.x, q.z), vec2(0.0), radius, 6.0), q.y, half_height);
}

// `radius` reaches from the axis to the three corners, of which one points along z.
float distance_triangular_prism(vec3 p, vec3 centre, float radius, float half_height) {
    vec3 q = p - centre;
    return op_extrude(distance_regular_polygon(vec2(q.x, q.z), vec2(0.0), radius, 3.0), q.y, half_height);
}

// The corners are half_width.x from the axis along x, and half_width.y along z.
float distance_rhombus_prism(vec3 p, vec3 centre, vec2 half_width, float half_height) {
    vec3 q = p - centre;
    return op_extrude(distance_rhombus(vec2(q.x, q.z), vec2(0.0), half_width), q.y, half_height);
}
