#include "math/dialect.glsl"

// Flat figures with round sides. The distances are exact.

float distance_circle(vec2 p, vec2 centre, float radius) {
    return length(p - centre) - radius;
}

// Half of `thickness` is on each side of the circle.
float distance_ring(vec2 p, vec2 centre, float radius, float thickness) {
    return abs(length(p - centre) - radius) - 0.5 * thickness;
}

// A part of a ring with round ends. It reaches half_angle radians, less than PI, to each side of the y axis. The distance inside is exact while the
// ends are apart.
float distance_arc(vec2 p, vec2 centre, float radius, float half_angle, float thickness) {
    vec2 q = vec2(abs(p.x - centre.x), p.y - centre.y);
    vec2 end = vec2(sin(half_angle), cos(half_angle));
    float to_circle = abs(length(q) - radius);
    float to_end = length(q - radius * end);
    return (end.y * q.x > end.x * q.y ? to_end : to_circle) - 0.5 * thickness;
}

// A circle without a second one of other_radius, whose centre is `shift` away along x. The two circles have to cross.
float distance_moon(vec2 p, vec2 centre, float radius, float other_radius, float shift) {
    vec2 q = vec2(p.x - centre.x, abs(p.y - centre.y));
    float along = 0.5 * (radius * radius - other_radius * other_radius + shift * shift) / shift;
    vec2 tip = vec2(along, sqrt(max(radius * radius - along * along, 0.0)));
    float to_tip = length(q - tip);
    float to_side = max(length(q) - radius, other_radius - length(q - vec2(shift, 0.0)));
    // Beyond the lines from both centres through the tip, no side faces the point.
    bool past_outer = q.x * tip.y > q.y * tip.x;
    bool past_inner = (q.x - shift) * tip.y > q.y * (tip.x - shift);
    return past_outer && past_inner ? to_tip : to_side;
}

// A heart that stands on its tip: two half circles on a square. It is 1.104 times `size` high and 1.207 times `size` wide.
float distance_heart(vec2 p, vec2 tip, float size) {
    vec2 q = vec2(abs(p.x - tip.x), p.y - tip.y);
    float to_circle = length(q - size * vec2(0.25, 0.75)) - size * 0.25 * sqrt(2.0);
    float to_notch = length(q - vec2(0.0, size));
    float to_side = length(q - 0.5 * max(q.x + q.y, 0.0));
    float to_corner = (q.x < q.y ? -1.0 : 1.0) * min(to_notch, to_side);
    return q.x + q.y > size ? to_circle : to_corner;
}

// The part of a circle within half_angle radians, less than PI, of the y axis, with its tip at the circle's centre.
float distance_pie(vec2 p, vec2 centre, float radius, float half_angle) {
    vec2 q = vec2(abs(p.x - centre.x), p.y - centre.y);
    vec2 edge = vec2(sin(half_angle), cos(half_angle));
    float to_edge = length(q - clamp(dot(q, edge), 0.0, radius) * edge);
    float side = edge.y * q.x < edge.x * q.y ? -1.0 : 1.0;
    return max(length(q) - radius, side * to_edge);
}
