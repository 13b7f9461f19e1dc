#include "distance/section.glsl"

// Distance to a solid cone that is cut off, from the middle of one end to the middle of the other end, each with its radius. In a half-plane
// through the axis it has a slanted side and two flat ends, of which the end of the nearer half alone can be nearest. The distance is exact.
float distance_capped_cone(vec3 p, vec3 end, vec3 other_end, float radius, float other_radius) {
    float height = length(other_end - end);
    vec2 q = op_revolve(p, end, (other_end - end) / height);
    vec2 slant = vec2(other_radius - radius, height);
    vec2 from_rim = q - vec2(radius, 0.0);
    vec2 to_side = from_rim - clamp(dot(from_rim, slant) / dot(slant, slant), 0.0, 1.0) * slant;
    float end_radius = q.y < 0.5 * height ? radius : other_radius;
    vec2 to_end = vec2(max(q.x - end_radius, 0.0), abs(q.y - 0.5 * height) - 0.5 * height);
    bool inside = to_end.y < 0.0 && from_rim.x * height < slant.x * q.y;
    return (inside ? -1.0 : 1.0) * sqrt(min(dot(to_side, to_side), dot(to_end, to_end)));
}
