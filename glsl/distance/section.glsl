#include "math/dialect.glsl"

// Solids made of flat figures. A figure is a distance in a plane: distance_circle(vec2 p, ...) and its like.

// Spins a figure about `axis`, which has unit length and goes through `centre`. The result is the point where the figure is asked: its
// distance from the axis, and its height along the axis. So the figure lies where the first coordinate is positive:
//
//     distance_rectangle(op_revolve(p, centre, axis), vec2(1.0, 0.0), vec2(0.2, 0.4))
//
// The distance is as exact as that of the figure, if the figure does not reach past the axis or is its own mirror image there.
vec2 op_revolve(vec3 p, vec3 centre, vec3 axis) {
    float height = dot(p - centre, axis);
    return vec2(length(p - centre - height * axis), height);
}

// Pulls a figure out of its plane, by half_height to each side. `d` is the figure's distance, and `height` the point's own height over the plane.
// The distance is as exact as that of the figure.
float op_extrude(float d, float height, float half_height) {
    vec2 past = vec2(d, abs(height) - half_height);
    return length(max(past, vec2(0.0))) + min(max(past.x, past.y), 0.0);
}
