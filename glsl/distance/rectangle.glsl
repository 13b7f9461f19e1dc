#include "math/dialect.glsl"

// Flat figures with right angles. The distances are exact.

float distance_rectangle(vec2 p, vec2 centre, vec2 half_size) {
    vec2 past = abs(p - centre) - half_size;
    return length(max(past, vec2(0.0))) + min(max(past.x, past.y), 0.0);
}

// `radius` is that of the corners.
float distance_rounded_rectangle(vec2 p, vec2 centre, vec2 half_size, float radius) {
    return distance_rectangle(p, centre, half_size - radius) - radius;
}

// A cross of two rectangles, from the centre to the ends half_length, and to the sides of an arm half_width.
float distance_cross(vec2 p, vec2 centre, float half_length, float half_width) {
    vec2 q = abs(p - centre);
    vec2 past = vec2(max(q.x, q.y) - half_length, min(q.x, q.y) - half_width);
    // Inside, an arm's end, its side or the corner between two arms is nearest.
    float to_corner = length(vec2(min(max(q.x, q.y) - half_width, 0.0), past.y));
    float depth = min(-past.x, to_corner);
    float reach = length(max(past, vec2(0.0)));
    return reach - (max(past.x, past.y) < 0.0 ? depth : 0.0);
}
