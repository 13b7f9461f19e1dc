// a: u, and a rectangle's azimuth and elevation; b: where a point is, and the rectangle's width. c: a direction toward the rectangle, and
// the condition; d: the solid angle, the density toward the middle, and that of the direction, times the solid angle if it is drawn by it.
#include "../item.glsl"
#include "math/rectangle.glsl"

void item(vec4 a, vec4 b, OUT(vec4) c, OUT(vec4) d) {
    mat3 rectangle = rectangle_facing(0.5, 1.0, -0.5, a.z, a.w, b.w, 1.0);
    // The point's image where the point itself is behind.
    vec3 facing = normalize(cross(rectangle[1], rectangle[2]));
    vec3 position = vec3(b) - 2.0 * min(dot(vec3(b) - rectangle[0], facing), 0.0) * facing;
    RectangleView view = rectangle_seen(rectangle, position);
    vec3 drawn = rectangle_sample(view, vec2(a));
    // A solid angle is a difference of larger ones, and close to the plane a small part of it is a long way.
    float small = view.solid_angle >= RECTANGLE_SMALL ? 1.0 + 1.0 / view.solid_angle : 1.0;
    float condition = small * max(length(position - rectangle[0]) / max(view.depth, 1.0e-6), 1.0);
    float due = rectangle_pdf(view, drawn) * (view.solid_angle >= RECTANGLE_SMALL ? view.solid_angle : 1.0);
    vec3 middle = normalize(rectangle[0] - position);
    c = vec4(drawn, condition);
    d = vec4(view.solid_angle, rectangle_pdf(view, middle), 0.0, due);
}
