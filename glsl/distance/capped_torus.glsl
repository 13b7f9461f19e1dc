#include "math/dialect.glsl"

// Distance to a part of a ring, with round ends. `axis` and `toward` have unit length and are at right angles. The middle of the part lies toward
// `toward`, and the part reaches half_angle radians, less than PI, to each side of it. The radii are those of distance_torus().
// The nearest point of the circle is straight out from the axis, or the part's end. The distance is exact while the ends are apart.
float distance_capped_torus(vec3 p, vec3 centre, vec3 axis, vec3 toward, float half_angle, float major, float minor) {
    vec3 from_centre = p - centre;
    float height = dot(from_centre, axis);
    vec2 q = vec2(dot(from_centre, toward), abs(dot(from_centre, cross(axis, toward))));
    vec2 end = vec2(cos(half_angle), sin(half_angle));
    float to_circle = length(q) - major;
    float to_end = length(q - major * end);
    float flat_distance = end.x * q.y > end.y * q.x ? to_end : to_circle;
    return length(vec2(flat_distance, height)) - minor;
}
