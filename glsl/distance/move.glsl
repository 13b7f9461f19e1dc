#include "math/dialect.glsl"

// A solid is moved by moving the point that is asked for the other way: distance_box(op_translate(p, by), ...).
vec3 op_translate(vec3 p, vec3 by) {
    return p - by;
}

// By `angle` radians about `axis` (of unit length), counter-clockwise when the axis points at the viewer. Rodrigues' formula.
vec3 op_rotate(vec3 p, vec3 axis, float angle) {
    float c = cos(angle);
    return c * p - sin(angle) * cross(axis, p) + (1.0 - c) * dot(axis, p) * axis;
}

// `factor` times as large. The distance has to be multiplied by it: factor * distance_box(op_scale(p, factor), ...).
vec3 op_scale(vec3 p, float factor) {
    return p / factor;
}
