#include "math/dialect.glsl"

// Distance to a solid cylinder from the middle of one end to the middle of the other end. After Quilez, "Distance functions".
float distance_cylinder(vec3 p, vec3 end, vec3 other_end, float radius) {
    float height = length(other_end - end);
    vec3 axis = (other_end - end) / height;
    vec3 from_centre = p - 0.5 * (end + other_end);
    float along = dot(from_centre, axis);
    vec2 past = vec2(length(from_centre - along * axis) - radius, abs(along) - 0.5 * height);
    return length(max(past, vec2(0.0))) + min(max(past.x, past.y), 0.0);
}
