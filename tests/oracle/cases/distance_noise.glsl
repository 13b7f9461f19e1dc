// a: a point. c: a ball raised by noise, and by octaves of it; a box in warped space; a line through points. d: a polygon; two characters; a noise of the
// vector.
#include "distance/box.glsl"
#include "distance/glyph.glsl"
#include "distance/noise.glsl"
#include "distance/polyline.glsl"
#include "distance/sphere.glsl"
#include "../item.glsl"

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    vec3 p = vec3(a);
    vec2 q = vec2(p.x, p.y);
    float ball = distance_sphere(p, vec3(0.125, -0.25, 0.5), 0.8);
    Polyline line = polyline_start(p, vec3(-0.8, -0.5, 0.3));
    polyline_to(line, vec3(0.1, 0.6, -0.2));
    polyline_to(line, vec3(0.5, -0.4, 0.1));
    Polyline outline = polyline_start(q, vec2(-0.9, -0.7));
    polyline_to(outline, vec2(0.8, -0.8));
    polyline_to(outline, vec2(0.2, 0.9));
    polyline_to(outline, vec2(-0.1, 0.0));
    c = vec4(op_noise(ball, p, 0.3, 0.4), op_noise_octaves(ball, p, 0.3, 0.8, 3),
             distance_box(op_warp(p, 0.2, 0.7), vec3(0.125, -0.25, 0.5), vec3(0.3, 0.6, 0.4)) / op_warp_steepness(0.2, 0.7),
             distance_polyline(line));
    d = vec4(distance_polygon(outline), min(distance_glyph(q, vec2(-0.6, -0.4), 0.8, 82), distance_glyph(q, vec2(0.1, -0.4), 0.8, 63)),
             noise_vector(p).z, 0.0);
}
