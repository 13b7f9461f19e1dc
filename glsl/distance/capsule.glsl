#include "math/dialect.glsl"

// Distance to the solid of all points within `radius` of the line from `end` to `other_end`.
float distance_capsule(vec3 p, vec3 end, vec3 other_end, float radius) {
    vec3 axis = other_end - end;
    float along = clamp(dot(p - end, axis) / dot(axis, axis), 0.0, 1.0);
    return length(p - end - along * axis) - radius;
}
