#include "distance/section.glsl"

// Distance to a cone with round ends: two balls, and all between them. It is the union of balls along the axis whose radii change steadily.
// The nearest ball is where the slant's normal through the point meets the axis, or at an end. The distance is exact.
float distance_round_cone(vec3 p, vec3 end, vec3 other_end, float radius, float other_radius) {
    float height = length(other_end - end);
    vec2 q = op_revolve(p, end, (other_end - end) / height);
    // The sine of the slant's angle against the axis. Beyond 1, one ball contains the other.
    float slope = (radius - other_radius) / height;
    float between = q.y - q.x * slope * inversesqrt(max(1.0 - slope * slope, 1.0e-12));
    float larger = slope > 0.0 ? 0.0 : height;
    float along = clamp(abs(slope) < 1.0 ? between : larger, 0.0, height);
    return length(vec2(q.x, q.y - along)) - mix(radius, other_radius, along / height);
}
