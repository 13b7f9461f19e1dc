#include "distance/section.glsl"

// Distance to a spindle with a tip at each end: an arc between the ends that is spun about the line between them. In the middle the arc is `radius`
// from that line, less than half of its length. The distance is exact.
float distance_vesica(vec3 p, vec3 end, vec3 other_end, float radius) {
    float tip = 0.5 * length(other_end - end);
    vec2 q = op_revolve(p, 0.5 * (end + other_end), 0.5 * (other_end - end) / tip);
    q.y = abs(q.y);
    // How far the middle of the arc's circle is past the axis.
    float past = 0.5 * (tip * tip - radius * radius) / radius;
    float to_tip = length(vec2(q.x, q.y - tip));
    float to_arc = length(vec2(q.x + past, q.y)) - (past + radius);
    return past * q.y > tip * (q.x + past) ? to_tip : to_arc;
}
