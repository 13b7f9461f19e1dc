#include "distance/segment.glsl"

// Distance to a pyramid with a square base along the axes x and z. `centre` is the middle of the base, half_width reaches from there to the base's
// sides, and the tip is `height` above. The distance is exact.
//
// One side stands for all four. It is a triangle: its distance is made of the height over its plane and of the distance in that plane.
float distance_pyramid(vec3 p, vec3 centre, float half_width, float height) {
    vec3 q = p - centre;
    float x = max(abs(q.x), abs(q.z));
    float z = min(abs(q.x), abs(q.z));
    float slant = length(vec2(half_width, height));
    vec2 down = vec2(half_width, -height) / slant;
    float over = (height * x + half_width * (q.y - height)) / slant;
    // Down the side from the tip, and across.
    vec2 in_plane = vec2(x * down.x + (q.y - height) * down.y, z);
    vec2 corner = vec2(slant, half_width);
    bool beside = in_plane.y * corner.x > in_plane.x * corner.y;
    bool below = in_plane.x > slant;
    float to_edge = distance_segment(in_plane, vec2(0.0), corner);
    float to_bottom = length(vec2(max(in_plane.x - slant, 0.0), max(z - half_width, 0.0)));
    float past = min(beside ? to_edge : INFINITY, below ? to_bottom : INFINITY);
    past = beside || below ? past : 0.0;
    vec3 to_base = vec3(max(x - half_width, 0.0), q.y, max(z - half_width, 0.0));
    bool inside = q.y > 0.0 && over < 0.0;
    return (inside ? -1.0 : 1.0) * sqrt(min(over * over + past * past, dot(to_base, to_base)));
}
