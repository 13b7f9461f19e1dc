#include "distance/segment.glsl"

// Flat figures with straight sides. The distances are exact.

// Folds a plane about the origin into one of `count` equal sectors, and that about its middle. What points along y before points along the sector's
// edge, half_angle away from the first coordinate.
vec2 polygon_sector(vec2 p, float half_angle) {
    // The angle of a point on the y axis is 0, and that of the origin does not matter.
    float angle = atan(p.x, abs(p.x) + abs(p.y) > 0.0 ? p.y : 1.0);
    float folded = mod(angle, 2.0 * half_angle) - half_angle;
    return length(p) * vec2(cos(folded), abs(sin(folded)));
}

// A polygon with `sides` equal sides, 3 or more. `radius` reaches from the centre to the corners, of which one points along y.
float distance_regular_polygon(vec2 p, vec2 centre, float radius, float sides) {
    float half_angle = PI / sides;
    vec2 past = polygon_sector(p - centre, half_angle) - radius * vec2(cos(half_angle), sin(half_angle));
    return length(max(past, vec2(0.0))) + min(past.x, 0.0);
}

// A star whose `points` tips are `radius` from the centre, and the corners between them inner_radius. One tip points along y.
float distance_star(vec2 p, vec2 centre, float radius, float inner_radius, float points) {
    float half_angle = PI / points;
    vec2 q = polygon_sector(p - centre, half_angle);
    vec2 inner = vec2(inner_radius, 0.0);
    vec2 tip = radius * vec2(cos(half_angle), sin(half_angle));
    vec2 side = tip - inner;
    bool inside = (q.x - inner.x) * side.y < (q.y - inner.y) * side.x;
    return (inside ? -1.0 : 1.0) * distance_segment(q, inner, tip);
}

// The corners are half_width.x from the centre along x, and half_width.y along y.
float distance_rhombus(vec2 p, vec2 centre, vec2 half_width) {
    vec2 q = abs(p - centre);
    bool inside = q.x * half_width.y + q.y * half_width.x < half_width.x * half_width.y;
    return (inside ? -1.0 : 1.0) * distance_segment(q, vec2(half_width.x, 0.0), vec2(0.0, half_width.y));
}

// Which side of the line from a to b the point is on.
float polygon_side(vec2 p, vec2 a, vec2 b) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// The corners may go around either way.
float distance_triangle(vec2 p, vec2 a, vec2 b, vec2 c) {
    float reach = min(min(distance_segment(p, a, b), distance_segment(p, b, c)), distance_segment(p, c, a));
    float turn = polygon_side(a, b, c) < 0.0 ? -1.0 : 1.0;
    float least = min(min(turn * polygon_side(p, a, b), turn * polygon_side(p, b, c)), turn * polygon_side(p, c, a));
    return (least > 0.0 ? -1.0 : 1.0) * reach;
}
