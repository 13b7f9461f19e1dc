// a: a point. c: distances to a rounded box, a cylinder, a capsule, a cone; d: to a torus, an ellipsoid, copies of a box, and
// a smooth union.
#include "../item.glsl"
#include "distance/boolean.glsl"
#include "distance/box.glsl"
#include "distance/capsule.glsl"
#include "distance/cone.glsl"
#include "distance/cylinder.glsl"
#include "distance/disk.glsl"
#include "distance/elongate.glsl"
#include "distance/ellipsoid.glsl"
#include "distance/move.glsl"
#include "distance/offset.glsl"
#include "distance/plane.glsl"
#include "distance/repeat.glsl"
#include "distance/rounded_box.glsl"
#include "distance/smooth.glsl"
#include "distance/sphere.glsl"
#include "distance/torus.glsl"

float copies(vec3 p) {
    float d = INFINITY;
    for (int i = 0; i < 4; i++) {
        vec3 q = repeat_cell(p, vec3(0.7, 0.0, 1.1), vec3(0.0, 0.0, 4.0), i);
        d = op_union(d, distance_box(op_rotate(q, vec3(0.0, 1.0, 0.0), 0.4), vec3(0.0), vec3(0.2, 0.5, 0.1)));
    }
    return d;
}

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    vec3 p = vec3(a);
    vec3 centre = vec3(0.125, -0.25, 0.5);
    vec3 axis = vec3(0.48, 0.6, 0.64);
    vec3 half_size = vec3(0.7, 0.4, 1.0);
    float torus = distance_torus(p, centre, axis, 0.8, 0.3);
    float disk = op_round(distance_disk(p, centre, axis, 0.9), 0.1);
    float ball = op_shell(distance_sphere(op_elongate(op_translate(p, centre), 0.3 * half_size), vec3(0.0), 0.6), 0.1);
    float cut = op_intersection(ball, op_inverse(distance_plane(op_scale(p, 2.0), axis, 0.1) * 2.0));
    c = vec4(distance_rounded_box(p, centre, half_size, 0.25),
             distance_cylinder(p, centre - 0.8 * axis, centre + 0.8 * axis, 0.4),
             distance_capsule(p, centre - 0.6 * axis, centre + 0.6 * axis, 0.4),
             distance_cone(p, centre - 0.8 * axis, centre + 0.8 * axis, 0.6));
    d = vec4(op_subtraction(torus, cut), distance_ellipsoid(p, centre, half_size), copies(p),
             op_smooth_subtraction(op_smooth_intersection(op_smooth_union(disk, torus, 0.3), ball, 0.2), cut, 0.1));
}
