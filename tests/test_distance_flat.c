/* Flat figures as distances: pulled out of their plane and spun, beside the solids that this makes, whose
 * outlines are said by parameters here.
 */
#include "solid.h"
#include "support.h"

#include <math.h>

static Context context;
static const double PI2 = 6.283185307179586;

typedef struct Point {
    double x, y;
} Point;

static Point around(double x, double y, double radius, double angle) {
    return (Point){x + radius * cos(angle), y + radius * sin(angle)};
}

static Point between(Point a, Point b, double t) {
    return (Point){place_mixed(a.x, b.x, t), place_mixed(a.y, b.y, t)};
}

/* The corners, one after the other. */
static Point polygon(const Point *corners, int count, int side, double t) {
    return between(corners[side % count], corners[(side + 1) % count], t);
}

static bool polygon_has(const Point *c, int count, Point p) {
    bool in = false;
    for (int i = 0, k = count - 1; i < count; k = i++) {
        if ((c[i].y > p.y) != (c[k].y > p.y) &&
            p.x < c[i].x + (c[k].x - c[i].x) * (p.y - c[i].y) / (c[k].y - c[i].y))
            in = !in;
    }
    return in;
}

static double span(Point a, double x, double y) {
    return hypot(a.x - x, a.y - y);
}

static Point circle(int piece, double t) {
    (void)piece;
    return around(0, 0, 0.7, PI2 * t);
}

static bool circle_has(Point p) {
    return span(p, 0, 0) < 0.7;
}

static Point ring(int piece, double t) {
    return around(0, 0, piece ? 0.6 : 0.8, PI2 * t);
}

static bool ring_has(Point p) {
    return fabs(span(p, 0, 0) - 0.7) < 0.1;
}

static Point arc(int piece, double t) {
    double side = piece == 3 ? -1 : 1, end = PI2 / 4 - side * 2.2;
    if (piece < 2) return around(0, 0, piece ? 0.6 : 0.8, PI2 / 4 + place_mixed(-2.2, 2.2, t));
    return around(0.7 * cos(end), 0.7 * sin(end), 0.1, end - side * PI2 / 2 * t);
}

static bool arc_has(Point p) {
    double turn = fmax(-2.2, fmin(atan2(p.x, p.y), 2.2));
    return span(p, 0.7 * sin(turn), 0.7 * cos(turn)) < 0.1;
}

/* Circles of the radii 0.8 and 0.6, 0.5 apart. */
static Point moon(int piece, double t) {
    double along = (0.64 - 0.36 + 0.25) / 1.0, high = sqrt(0.64 - along * along);
    double outer = atan2(high, along), inner = atan2(high, along - 0.5);
    return piece == 0 ? around(0, 0, 0.8, place_mixed(outer, PI2 - outer, t))
                      : around(0.5, 0, 0.6, place_mixed(inner, PI2 - inner, t));
}

static bool moon_has(Point p) {
    return span(p, 0, 0) < 0.8 && span(p, 0.5, 0) > 0.6;
}

/* Of the size 1: two half circles on the upper sides of a square that stands on its tip. */
static Point heart(int piece, double t) {
    double side = piece % 2 ? -1 : 1;
    Point p =
        piece < 2 ? (Point){0.5 * t, 0.5 * t} : around(0.25, 0.75, sqrt(0.125), PI2 * (0.5 * t - 0.125));
    return (Point){side * p.x, p.y};
}

static bool heart_has(Point p) {
    double x = fabs(p.x);
    return (p.y > x && x + p.y <= 1) || (x + p.y > 1 && span((Point){x, p.y}, 0.25, 0.75) < sqrt(0.125));
}

/* A circle's part, 2.2 or 0.6 to each side of the y axis. */
static Point slice_at(double half_angle, int piece, double t) {
    double side = piece == 1 ? -1 : 1;
    return piece < 2 ? around(0, 0, 0.8 * t, PI2 / 4 - side * half_angle)
                     : around(0, 0, 0.8, PI2 / 4 + place_mixed(-half_angle, half_angle, t));
}

static Point slice(int piece, double t) {
    return slice_at(0.6, piece, t);
}

static bool slice_has(Point p) {
    return span(p, 0, 0) < 0.8 && fabs(atan2(p.x, p.y)) < 0.6;
}

static Point wide_slice(int piece, double t) {
    return slice_at(2.2, piece, t);
}

static bool wide_slice_has(Point p) {
    return span(p, 0, 0) < 0.8 && fabs(atan2(p.x, p.y)) < 2.2;
}

/* Two circles, without what they share. */
static Point either(int piece, double t) {
    return piece ? around(0.5, 0.2, 0.6, PI2 * t) : around(-0.2, 0, 0.7, PI2 * t);
}

static bool either_has(Point p) {
    return (span(p, 0.5, 0.2) < 0.6) != (span(p, -0.2, 0) < 0.7);
}

static Point ellipse(int piece, double t) {
    (void)piece;
    return (Point){0.9 * cos(PI2 * t), 0.3 * sin(PI2 * t)};
}

static bool ellipse_has(Point p) {
    return span((Point){p.x / 0.9, p.y / 0.3}, 0, 0) < 1;
}

static Point rounded(int piece, double t) {
    int corner = piece % 4;
    double x = corner == 0 || corner == 3 ? 0.5 : -0.5, y = corner < 2 ? 0.2 : -0.2;
    if (piece < 4) return around(x, y, 0.2, PI2 / 4 * (corner + t));
    Point a = around(x, y, 0.2, PI2 / 4 * (corner + 1));
    return between(a, corner % 2 ? (Point){a.x, -a.y} : (Point){-a.x, a.y}, t);
}

static bool rounded_has(Point p) {
    return span((Point){fmax(fabs(p.x) - 0.5, 0), fmax(fabs(p.y) - 0.2, 0)}, 0, 0) < 0.2;
}

static const Point oblong_corners[] = {{0.7, 0.4}, {-0.7, 0.4}, {-0.7, -0.4}, {0.7, -0.4}};
static const Point cross_corners[] = {{0.9, 0.25},   {0.25, 0.25}, {0.25, 0.9},   {-0.25, 0.9},
                                      {-0.25, 0.25}, {-0.9, 0.25}, {-0.9, -0.25}, {-0.25, -0.25},
                                      {-0.25, -0.9}, {0.25, -0.9}, {0.25, -0.25}, {0.9, -0.25}};
static const Point kite_corners[] = {{0.8, 0.7}, {-0.6, 0.3}, {0.0, 0.0}, {-0.1, -0.8}};
static const Point table_corners[] = {{-0.9, -0.4}, {0.9, -0.4}, {0.3, 0.4}, {-0.3, 0.4}};
static const Point leaning_corners[] = {{-0.9, -0.4}, {0.3, -0.4}, {0.9, 0.4}, {-0.3, 0.4}};
static const Point wedge_corners[] = {{0.7, 0.1}, {-0.5, 0.6}, {-0.2, -0.8}};

/* Corners at the radii in turn, the first of them along y. */
static void star_corners(Point *corners, int count, double radius, double inner) {
    for (int i = 0; i < count; i++)
        corners[i] = around(0, 0, i % 2 ? inner : radius, PI2 * (0.25 + (double)i / count));
}

#define POLYGON(name, count)                                                                                 \
    static Point name(int piece, double t) {                                                                 \
        return polygon(name##_corners, count, piece, t);                                                     \
    }                                                                                                        \
    static bool name##_has(Point p) {                                                                        \
        return polygon_has(name##_corners, count, p);                                                        \
    }
#define STAR(name, count, radius, inner)                                                                     \
    static Point name(int piece, double t) {                                                                 \
        Point corners[count];                                                                                \
        star_corners(corners, count, radius, inner);                                                         \
        return polygon(corners, count, piece, t);                                                            \
    }                                                                                                        \
    static bool name##_has(Point p) {                                                                        \
        Point corners[count];                                                                                \
        star_corners(corners, count, radius, inner);                                                         \
        return polygon_has(corners, count, p);                                                               \
    }
POLYGON(oblong, 4)
POLYGON(cross, 12)
POLYGON(wedge, 3)
POLYGON(kite, 4)
POLYGON(table, 4)
POLYGON(leaning, 4)
STAR(pentagon, 5, 0.8, 0.8)
STAR(square, 4, 0.8, 0.8)
STAR(star, 10, 0.9, 0.4)
STAR(needles, 14, 1.0, 0.2)

/* A line and a curve, drawn 0.2 wide. */
static Point line(int piece, double t) {
    Point a = {-0.6, -0.3}, b = {0.5, 0.4};
    double angle = atan2(b.y - a.y, b.x - a.x) + PI2 / 4, side = piece % 2 ? -1 : 1;
    if (piece < 2)
        return between(around(a.x, a.y, side * 0.1, angle), around(b.x, b.y, side * 0.1, angle), t);
    return piece == 2 ? around(a.x, a.y, 0.1, angle + PI2 / 2 * t)
                      : around(b.x, b.y, 0.1, angle - PI2 / 2 * t);
}

static bool line_has(Point p) {
    double t = fmin(fmax(((p.x + 0.6) * 1.1 + (p.y + 0.3) * 0.7) / 1.7, 0), 1);
    return span(p, -0.6 + 1.1 * t, -0.3 + 0.7 * t) < 0.1;
}

static Point curve_middle(double t, double *angle) {
    Point a = {-0.8, -0.4}, b = {0.1, 1.1}, c = {0.7, -0.3};
    Point from = between(a, b, t), to = between(b, c, t);
    *angle = atan2(to.y - from.y, to.x - from.x) + PI2 / 4;
    return between(from, to, t);
}

static Point curve(int piece, double t) {
    double angle, side = piece % 2 ? -1 : 1;
    Point at = curve_middle(piece < 2 ? t : piece - 2, &angle);
    return around(at.x, at.y, side * 0.1, piece < 2 ? angle : angle + PI2 / 2 * t);
}

static bool curve_has(Point p) {
    for (int i = 0; i <= 4000; i++) {
        double angle;
        Point at = curve_middle(i / 4000.0, &angle);
        if (span(p, at.x, at.y) < 0.1) return true;
    }
    return false;
}

/* A figure in space reaches along z without an end. */
#define FIGURE(name)                                                                                         \
    static Place name##_pulled(int piece, double u, double v) {                                              \
        Point p = name(piece, v);                                                                            \
        return (Place){p.x, p.y, 16 * (u - 0.5)};                                                            \
    }                                                                                                        \
    static bool name##_solid_has(Place p) {                                                                  \
        return name##_has((Point){p.x, p.y});                                                                \
    }
FIGURE(circle)
FIGURE(ring)
FIGURE(arc)
FIGURE(moon)
FIGURE(heart)
FIGURE(ellipse)
FIGURE(rounded)
FIGURE(oblong)
FIGURE(cross)
FIGURE(wedge)
FIGURE(kite)
FIGURE(table)
FIGURE(leaning)
FIGURE(slice)
FIGURE(wide_slice)
FIGURE(either)
FIGURE(pentagon)
FIGURE(square)
FIGURE(star)
FIGURE(needles)
FIGURE(line)
FIGURE(curve)

/* The star pulled out by 0.5 to each side, with its ends in fans about the axis; and spun, a metre off the
 * axis. */
static Place star_bar(int patch, double u, double v) {
    double place = fmin(10 * v, 10 - 1e-12);
    Point p = patch < 10 ? star(patch, v) : star((int)place, place - floor(place));
    return patch < 10 ? (Place){p.x, p.y, u - 0.5} : (Place){u * p.x, u * p.y, patch == 10 ? -0.5 : 0.5};
}

static bool star_bar_has(Place p) {
    return star_has((Point){p.x, p.y}) && fabs(p.z) < 0.5;
}

static Place star_spun(int patch, double u, double v) {
    Point p = star(patch, u);
    return place_spun(1 + p.x, p.y, v);
}

static bool star_spun_has(Place p) {
    return star_has((Point){place_across(p) - 1, p.y});
}

#define FILE_OF(name) "#include \"distance/" name ".glsl\"\n"
#define Q "vec2(p.x, p.y), s * vec2(C.x, C.y), "
#define AT(x, y) "s * (vec2(C.x, C.y) + vec2(" #x ", " #y "))"
#define ROW(file, name, expression, figure, pieces)                                                          \
    {                                                                                                        \
        FILE_OF(file)                                                                                        \
        FILE_OF("offset"), name, expression, figure##_pulled, pieces, figure##_solid_has, false, false       \
    }
static const Solid solids[] = {
    ROW("round", "circle", "distance_circle(" Q "s * 0.7)", circle, 1),
    ROW("round", "ring", "distance_ring(" Q "s * 0.7, s * 0.2)", ring, 2),
    ROW("round", "arc", "distance_arc(" Q "s * 0.7, 2.2, s * 0.2)", arc, 4),
    ROW("round", "moon", "distance_moon(" Q "s * 0.8, s * 0.6, s * 0.5)", moon, 2),
    ROW("round", "heart", "distance_heart(" Q "s)", heart, 4),
    ROW("round", "pie", "distance_pie(" Q "s * 0.8, 0.6)", slice, 3),
    ROW("round", "pie, more than half", "distance_pie(" Q "s * 0.8, 2.2)", wide_slice, 3),
    ROW("quadrilateral", "quadrilateral",
        "distance_quadrilateral(vec2(p.x, p.y), " AT(0.8, 0.7) ", " AT(-0.6, 0.3) ", " AT(0.0, 0.0) ", " AT(
            -0.1, -0.8) ")",
        kite, 4),
    ROW("quadrilateral", "quadrilateral, the other way around",
        "distance_quadrilateral(vec2(p.x, p.y), " AT(-0.1, -0.8) ", " AT(0.0, 0.0) ", " AT(-0.6, 0.3) ", " AT(
            0.8, 0.7) ")",
        kite, 4),
    ROW("quadrilateral", "trapezoid", "distance_trapezoid(" Q "s * 0.9, s * 0.3, s * 0.4)", table, 4),
    ROW("quadrilateral", "parallelogram", "distance_parallelogram(" Q "s * vec2(0.6, 0.4), s * 0.3)", leaning,
        4),
    {FILE_OF("round") FILE_OF("boolean"), "op_xor",
     "op_xor(distance_circle(vec2(p.x, p.y), " AT(
         -0.2, 0.0) ", s * 0.7), distance_circle(vec2(p.x, p.y), " AT(0.5, 0.2) ", s * 0.6))",
     either_pulled, 2, either_solid_has, false, false},
    ROW("ellipse", "ellipse", "distance_ellipse(" Q "s * vec2(0.9, 0.3))", ellipse, 1),
    ROW("rectangle", "rectangle", "distance_rectangle(" Q "s * vec2(0.7, 0.4))", oblong, 4),
    ROW("rectangle", "rounded_rectangle", "distance_rounded_rectangle(" Q "s * vec2(0.7, 0.4), s * 0.2)",
        rounded, 8),
    ROW("rectangle", "cross", "distance_cross(" Q "s * 0.9, s * 0.25)", cross, 12),
    ROW("polygon", "triangle",
        "distance_triangle(vec2(p.x, p.y), " AT(0.7, 0.1) ", " AT(-0.5, 0.6) ", " AT(-0.2, -0.8) ")", wedge,
        3),
    ROW("polygon", "triangle, the other way around",
        "distance_triangle(vec2(p.x, p.y), " AT(0.7, 0.1) ", " AT(-0.2, -0.8) ", " AT(-0.5, 0.6) ")", wedge,
        3),
    ROW("polygon", "regular_polygon of 5", "distance_regular_polygon(" Q "s * 0.8, 5.0)", pentagon, 5),
    ROW("polygon", "regular_polygon of 4", "distance_regular_polygon(" Q "s * 0.8, 4.0)", square, 4),
    ROW("polygon", "star of 5", "distance_star(" Q "s * 0.9, s * 0.4, 5.0)", star, 10),
    ROW("polygon", "star of 7", "distance_star(" Q "s, s * 0.2, 7.0)", needles, 14),
    ROW("segment", "segment",
        "op_round(distance_segment(vec2(p.x, p.y), " AT(-0.6, -0.3) ", " AT(0.5, 0.4) "), s * 0.1)", line, 4),
    ROW("bezier", "quadratic_bezier",
        "op_round(distance_quadratic_bezier(vec2(p.x, p.y), " AT(-0.8, -0.4) ", " AT(0.1, 1.1) ", " AT(
            0.7, -0.3) "), s * 0.1)",
        curve, 4),
    {FILE_OF("polygon") FILE_OF("section"), "op_extrude",
     "op_extrude(distance_star(" Q "s * 0.9, s * 0.4, 5.0), p.z - s * C.z, s * 0.5)", star_bar, 12,
     star_bar_has, false, false},
    {FILE_OF("polygon") FILE_OF("section"), "op_revolve",
     "distance_star(op_revolve(p, s * C, N), s * vec2(1.0, 0.0), s * 0.9, s * 0.4, 5.0)", star_spun, 10,
     star_spun_has, true, false},
};
enum { SOLIDS = sizeof solids / sizeof *solids };

static void test_figures(void **state) {
    (void)state;
    support_open(&context);
    solid_test_exact(&context, solids, SOLIDS, SOLID_ITEMS / 2);
    context_close(&context);
}

static void test_wrong_size(void **state) {
    (void)state;
    support_open(&context);
    solid_test_wrong_size(&context, solids, SOLIDS);
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_figures), cmocka_unit_test(test_wrong_size)};
    return cmocka_run_group_tests_name("distance_flat", tests, support_folder, support_clean);
}
