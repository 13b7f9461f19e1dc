#include "math/dialect.glsl"

// Distance in a plane to a line between two points. It has no inside: op_round() gives it a width.
float distance_segment(vec2 p, vec2 end, vec2 other_end) {
    vec2 along = other_end - end;
    float at = clamp(dot(p - end, along) / dot(along, along), 0.0, 1.0);
    return length(p - end - at * along);
}
