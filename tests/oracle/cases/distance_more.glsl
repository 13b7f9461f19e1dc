// a: a point. c: distances to a round cone, a spindle, a pyramid with a bowl, a tube; d: to flat figures, a prism and a frame, joined; to an
// octahedron and an engraved cone; to a twisted link; to copies that differ, and copies around an axis.
#include "distance/bezier.glsl"
#include "distance/boolean.glsl"
#include "distance/box_frame.glsl"
#include "distance/capped_cone.glsl"
#include "distance/capped_torus.glsl"
#include "distance/cut_sphere.glsl"
#include "distance/deform.glsl"
#include "distance/ellipse.glsl"
#include "distance/infinite.glsl"
#include "distance/join.glsl"
#include "distance/link.glsl"
#include "distance/mirror.glsl"
#include "distance/octahedron.glsl"
#include "distance/prism.glsl"
#include "distance/pyramid.glsl"
#include "distance/quadrilateral.glsl"
#include "distance/rectangle.glsl"
#include "distance/repeat_polar.glsl"
#include "distance/repeat_random.glsl"
#include "distance/round.glsl"
#include "distance/round_cone.glsl"
#include "distance/smooth_kinds.glsl"
#include "distance/sphere.glsl"
#include "distance/vesica.glsl"
#include "../item.glsl"

float scattered(vec3 p) {
    vec3 spacing = vec3(0.7, 0.0, 1.1);
    float d = repeat_reach(spacing);
    for (int i = 0; i < 4; i++) {
        vec3 random = repeat_random(repeat_index(p, spacing, vec3(0.0), i), 1u);
        d = min(d, distance_sphere(repeat_cell(p, spacing, vec3(0.0), i), 0.2 * (random - 0.5), 0.1 + 0.1 * random.x));
    }
    return d;
}

float around(vec3 p) {
    vec2 size = vec2(0.1, 0.3);
    vec3 near = repeat_polar(p, 5.0, 0);
    vec3 beside = repeat_polar(p, 5.0, 1);
    return min(distance_cross(vec2(near.x, near.y), vec2(0.6, 0.0), size.y, size.x),
               distance_cross(vec2(beside.x, beside.y), vec2(0.6, 0.0), size.y, size.x));
}

float four_sides(vec2 p) {
    float bent = distance_quadrilateral(p, vec2(-0.7, -0.3), vec2(0.1, -0.1), vec2(0.6, -0.6), vec2(0.2, 0.7));
    float even = min(distance_trapezoid(p, vec2(0.2, 0.4), 0.5, 0.3, 0.2), distance_parallelogram(p, vec2(-0.2, 0.3), vec2(0.3, 0.2), 0.25));
    return op_xor(distance_pie(p, vec2(0.1, -0.4), 0.7, 0.6), op_xor(bent, even));
}

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    vec3 p = vec3(a);
    vec3 centre = vec3(0.125, -0.25, 0.5);
    vec3 axis = vec3(0.48, 0.6, 0.64);
    vec3 across = vec3(0.8, 0.0, -0.6);
    vec2 flat_p = op_revolve(p, centre, axis) - vec2(0.9, 0.0);
    float star = distance_star(flat_p, vec2(0.0), 0.5, 0.2, 5.0);
    float figures = min(min(distance_heart(flat_p, vec2(0.1), 0.5), distance_moon(flat_p, vec2(0.2), 0.5, 0.4, 0.3)),
                        min(distance_ellipse(flat_p, vec2(0.1), vec2(0.3, 0.6)), distance_arc(flat_p, vec2(0.0), 0.6, 0.8, 0.1)));
    float frame = distance_box_frame(p, centre, vec3(0.7, 0.4, 1.0), 0.2);
    float prism = distance_hexagonal_prism(p, centre, 0.7, 0.4);
    float cone = distance_capped_cone(p, centre - 0.5 * axis, centre + 0.5 * axis, 0.6, 0.3);
    float bowl = distance_cut_hollow_sphere(p, centre, axis, 0.8, 0.3, 0.1);
    c = vec4(distance_round_cone(p, centre - 0.5 * axis, centre + 0.5 * axis, 0.5, 0.2),
             distance_vesica(p, centre - 0.9 * axis, centre + 0.9 * axis, 0.4),
             op_smooth_union_circular(distance_pyramid(p, centre, 0.6, 0.9), bowl, 0.2),
             distance_bezier_tube(p, centre - across, centre + axis, centre + across, 0.2));
    d = vec4(op_chamfer_union(min(min(star, four_sides(flat_p)), figures), min(frame, prism), 0.1),
             op_smooth_union_root(distance_octahedron(p, centre, 0.8), op_engrave(cone, distance_infinite_cylinder(p, centre, across, 0.3), 0.1), 0.2),
             op_displace(distance_link(op_twist(op_mirror(p, axis, 0.0), 0.7), centre, axis, across, 0.4, 0.4, 0.1), 0.1, 0.5),
             min(scattered(p), around(p)));
}
