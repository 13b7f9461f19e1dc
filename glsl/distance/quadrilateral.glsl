#include "distance/polygon.glsl"

// Flat figures with four sides. The distances are exact.

// Whether a line from the point along x crosses the side from a to b. A corner belongs to one of its sides, so no line misses both.
bool quadrilateral_crosses(vec2 p, vec2 a, vec2 b) {
    bool spans = (a.y > p.y) != (b.y > p.y);
    bool before = (polygon_side(p, a, b) > 0.0) == (b.y > a.y);
    return spans && before;
}

// The corners go around either way, and one may point inward. The sides do not cross.
float distance_quadrilateral(vec2 p, vec2 a, vec2 b, vec2 c, vec2 d) {
    float reach = min(min(distance_segment(p, a, b), distance_segment(p, b, c)), min(distance_segment(p, c, d), distance_segment(p, d, a)));
    bool first = quadrilateral_crosses(p, a, b) != quadrilateral_crosses(p, b, c);
    bool second = quadrilateral_crosses(p, c, d) != quadrilateral_crosses(p, d, a);
    return (first != second ? -1.0 : 1.0) * reach;
}

// It reaches half_width to each side of its middle at the bottom, and top_half_width at the top.
float distance_trapezoid(vec2 p, vec2 centre, float half_width, float top_half_width, float half_height) {
    vec2 bottom = vec2(half_width, -half_height);
    vec2 top = vec2(top_half_width, half_height);
    return distance_quadrilateral(p - centre, vec2(-bottom.x, bottom.y), bottom, top, vec2(-top.x, top.y));
}

// The top is shifted by `shift` along x, and the bottom as far the other way.
float distance_parallelogram(vec2 p, vec2 centre, vec2 half_size, float shift) {
    vec2 corner = vec2(half_size.x + shift, half_size.y);
    vec2 other = vec2(shift - half_size.x, half_size.y);
    return distance_quadrilateral(p - centre, -corner, -other, corner, other);
}
