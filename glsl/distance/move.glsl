#include "math/dialect.glsl"

// To move a solid, move the point in the opposite direction: distance_box(op_translate(p, by), ...).
vec3 op_translate(vec3 p, vec3 by) {
    return p - by;
}

// Rotates a solid by `angle` radians about `axis`, which has unit length. The rotation is counter-clockwise if the axis points at the viewer.
// The formula is Rodrigues'.
vec3 op_rotate(vec3 p, vec3 axis, float angle) {
    float c = cos(angle);
    return c * p - sin(angle) * cross(axis, p) + (1.0 - c) * dot(axis, p) * axis;
}

// Makes a solid `factor` times as large. Multiply the distance by the factor too: factor * distance_box(op_scale(p, factor), ...).
vec3 op_scale(vec3 p, float factor) {
    return p / factor;
}
