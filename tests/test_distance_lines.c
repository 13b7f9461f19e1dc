/* Lines through many points, as distances: tubes about them and polygons, beside the least distance to points
 * of their outlines, which are said by their corners here.
 */
#include "solid.h"
#include "support.h"

#include <math.h>
#include <string.h>

static Context context;
static const double PI2 = 6.283185307179586;

/* A tube about the way through these points, in space and in the plane. What lies within the tube at its
 * bends is nearer to no point outside. */
static const Place bends[] = {{-0.8, -0.5, 0.3}, {0.1, 0.6, -0.2}, {0.5, -0.4, 0.1}, {0.6, -0.3, 0.7}};
static const Place flat_bends[] = {{-0.8, -0.5, 0}, {0.1, 0.6, 0}, {0.5, -0.4, 0}, {0.9, 0.4, 0}};
enum { LINES = 3 };

static Place tube_at(int patch, double u, double v) {
    Place a = bends[patch % LINES], b = bends[patch % LINES + 1];
    double way = patch < 2 * LINES ? -1 : 1, t = patch < LINES ? u : patch < 2 * LINES ? 0 : 1;
    Place at = {place_mixed(a.x, b.x, t), place_mixed(a.y, b.y, t), place_mixed(a.z, b.z, t)};
    Place along = place_united((Place){way * (b.x - a.x), way * (b.y - a.y), way * (b.z - a.z)});
    return patch < LINES ? place_tube(at, along, 0.25, v) : place_tube_end(at, along, 0.25, u, v);
}

static bool near_lines(const Place *points, double radius, Place p) {
    for (int i = 0; i < LINES; i++) {
        for (int k = 0; k <= 1000; k++) {
            Place a = points[i], b = points[i + 1];
            double t = k / 1000.0;
            Place at = {place_mixed(a.x, b.x, t), place_mixed(a.y, b.y, t), place_mixed(a.z, b.z, t)};
            if (place_distance2(p, at) < radius * radius) return true;
        }
    }
    return false;
}

static bool tube_has(Place p) {
    return near_lines(bends, 0.25, p);
}

/* The solids in a plane reach along z without an end. */
static Place stroke_at(int patch, double u, double v) {
    Place a = flat_bends[patch / 4], b = flat_bends[patch / 4 + 1];
    int piece = patch % 4;
    double across = atan2(b.y - a.y, b.x - a.x) + PI2 / 4, t = piece < 2 ? v : piece - 2;
    double angle = piece < 2 ? across + piece * PI2 / 2 : across + (piece == 2 ? v : -v) * PI2 / 2;
    Place at = {place_mixed(a.x, b.x, t), place_mixed(a.y, b.y, t), 0};
    return (Place){at.x + 0.1 * cos(angle), at.y + 0.1 * sin(angle), 16 * (u - 0.5)};
}

static bool stroke_has(Place p) {
    return near_lines(flat_bends, 0.1, (Place){p.x, p.y, 0});
}

static const double wall[][2] = {{-0.9, -0.7}, {0.8, -0.8}, {0.9, 0.1}, {0.3, -0.2},
                                 {0.2, 0.9},   {-0.1, 0.0}, {-0.6, 0.6}};
static const double pentagram[][2] = {{0, 0.9}, {0.53, -0.73}, {-0.86, 0.28}, {0.86, 0.28}, {-0.53, -0.73}};

static Place side_at(const double (*corners)[2], int count, int side, double u, double v) {
    const double *a = corners[side], *b = corners[(side + 1) % count];
    return (Place){place_mixed(a[0], b[0], v), place_mixed(a[1], b[1], v), 16 * (u - 0.5)};
}

static bool sides_have(const double (*corners)[2], int count, Place p) {
    bool in = false;
    for (int i = 0; i < count; i++) {
        const double *a = corners[i], *b = corners[(i + 1) % count];
        in ^= (a[1] > p.y) != (b[1] > p.y) && p.x < a[0] + (b[0] - a[0]) * (p.y - a[1]) / (b[1] - a[1]);
    }
    return in;
}

static Place wall_at(int side, double u, double v) {
    return side_at(wall, 7, side, u, v);
}

static bool wall_has(Place p) {
    return sides_have(wall, 7, p);
}

static Place pentagram_at(int side, double u, double v) {
    return side_at(pentagram, 5, side, u, v);
}

static bool pentagram_has(Place p) {
    return sides_have(pentagram, 5, p);
}

#define FILE_OF(name) "#include \"distance/" name ".glsl\"\n"
/* A GLSL function of the name over these statements, in which AT() and IN_SPACE() are points about the
 * centre. */
#define LINE(name, statements)                                                                               \
    FILE_OF("polyline")                                                                                      \
    FILE_OF("offset")                                                                                        \
    "#define AT(x, y) s * vec2(0.125 + (x), -0.25 + (y))\n"                                                  \
    "#define IN_SPACE(x, y, z) s * vec3(0.125 + (x), -0.25 + (y), 0.5 + (z))\n"                              \
    "float " name "(vec3 p, float s) { vec2 q = vec2(p.x, p.y); " statements " }\n"
static const Solid solids[] = {
    {LINE("tube",
          "Polyline line = polyline_start(p, IN_SPACE(-0.8, -0.5, 0.3)); polyline_to(line, IN_SPACE(0.1, "
          "0.6, -0.2)); polyline_to(line, IN_SPACE(0.1, 0.6, -0.2)); polyline_to(line, IN_SPACE(0.5, -0.4, "
          "0.1)); polyline_to(line, IN_SPACE(0.6, -0.3, 0.7)); return op_round(distance_polyline(line), s * "
          "0.25);"),
     "tube through four points", "tube(p, s)", tube_at, 3 * LINES, tube_has, false, true},
    {LINE("stroke", "Polyline line = polyline_start(q, AT(-0.8, -0.5)); polyline_to(line, AT(0.1, 0.6)); "
                    "polyline_to(line, AT(0.5, -0.4)); polyline_to(line, AT(0.9, 0.4)); return "
                    "op_round(distance_polyline(line), s * 0.1);"),
     "stroke through four points", "stroke(p, s)", stroke_at, 4 * LINES, stroke_has, false, true},
    {LINE("wall",
          "Polyline line = polyline_start(q, AT(-0.9, -0.7)); polyline_to(line, AT(0.8, -0.8)); "
          "polyline_to(line, AT(0.9, 0.1)); polyline_to(line, AT(0.3, -0.2)); polyline_to(line, AT(0.2, "
          "0.9)); polyline_to(line, AT(-0.1, 0.0)); polyline_to(line, AT(-0.6, 0.6)); return "
          "distance_polygon(line);"),
     "polygon of 7", "wall(p, s)", wall_at, 7, wall_has, false, false},
    {LINE("wall",
          "Polyline line = polyline_start(q, AT(-0.9, -0.7)); polyline_to(line, AT(-0.6, 0.6)); "
          "polyline_to(line, AT(-0.1, 0.0)); polyline_to(line, AT(0.2, 0.9)); polyline_to(line, AT(0.3, "
          "-0.2)); polyline_to(line, AT(0.9, 0.1)); polyline_to(line, AT(0.8, -0.8)); polyline_to(line, "
          "AT(-0.9, -0.7)); return distance_polygon(line);"),
     "polygon of 7, the other way around and closed twice", "wall(p, s)", wall_at, 7, wall_has, false, false},
    {LINE("pentagram",
          "Polyline line = polyline_start(q, AT(0.0, 0.9)); polyline_to(line, AT(0.53, -0.73)); "
          "polyline_to(line, AT(-0.86, 0.28)); polyline_to(line, AT(0.86, 0.28)); polyline_to(line, "
          "AT(-0.53, -0.73)); return distance_polygon(line);"),
     "polygon whose sides cross", "pentagram(p, s)", pentagram_at, 5, pentagram_has, false, false},
};
enum { SOLIDS = sizeof solids / sizeof *solids };

static void test_lines(void **state) {
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

/* The points of each character's strokes, as their two coordinates on the grid. The pen is lifted at dashes.
 */
static const struct {
    char character;
    const char *points;
} glyphs[] = {
    {'!', "16 12 -- 10 10"},
    {'\'', "16 14"},
    {'(', "26 15 11 20"},
    {')', "16 25 21 10"},
    {'+', "14 12 -- 03 23"},
    {',', "11 00"},
    {'-', "03 23"},
    {'.', "10 10"},
    {'/', "00 36"},
    {'0', "01 05 16 26 35 31 20 10 01 35"},
    {'1', "05 16 10 -- 00 20"},
    {'2', "05 16 26 35 34 00 30"},
    {'3', "05 16 26 35 34 23 32 31 20 10 01"},
    {'4', "20 26 02 32"},
    {'5', "36 06 03 23 32 31 20 10 01"},
    {'6', "35 26 16 05 01 10 20 31 32 23 03"},
    {'7', "06 36 10"},
    {'8', "01 05 16 26 35 31 20 10 01 -- 03 33"},
    {'9', "01 10 20 31 35 26 16 05 04 13 33"},
    {':', "14 14 -- 11 11"},
    {'=', "04 24 -- 02 22"},
    {'?', "05 16 26 35 34 12 -- 10 10"},
    {'A', "00 04 16 26 34 30 -- 03 33"},
    {'B', "00 06 26 35 34 23 03 23 32 31 20 00"},
    {'C', "35 26 16 05 01 10 20 31"},
    {'D', "00 06 26 35 31 20 00"},
    {'E', "36 06 00 30 -- 03 23"},
    {'F', "36 06 00 -- 03 23"},
    {'G', "35 26 16 05 01 10 20 31 33 23"},
    {'H', "00 06 -- 30 36 -- 03 33"},
    {'I', "06 26 -- 16 10 -- 00 20"},
    {'J', "36 31 20 10 01"},
    {'K', "00 06 -- 36 03 30"},
    {'L', "06 00 30"},
    {'M', "00 06 13 23 36 30"},
    {'N', "00 06 30 36"},
    {'O', "01 05 16 26 35 31 20 10 01"},
    {'P', "00 06 26 35 34 23 03"},
    {'Q', "01 05 16 26 35 31 20 10 01 -- 12 30"},
    {'R', "00 06 26 35 34 23 03 13 30"},
    {'S', "35 26 16 05 04 13 23 32 31 20 10 01"},
    {'T', "06 26 -- 16 10"},
    {'U', "06 01 10 20 31 36"},
    {'V', "06 10 20 36"},
    {'W', "06 00 13 23 30 36"},
    {'X', "00 36 -- 06 30"},
    {'Y', "06 04 13 33 -- 36 31 20 10 01"},
    {'Z', "06 36 00 30"},
};
enum { GLYPHS = sizeof glyphs / sizeof *glyphs, SIDE = 128 };

static const char *points_of(int code) {
    for (int k = 0; k < GLYPHS; k++) {
        if (glyphs[k].character == code) return glyphs[k].points;
    }
    return "";
}

/* The least distance to the strokes on the grid. */
static double strokes_away(const char *points, double x, double y) {
    double least = 1e15, last[2] = {0};
    bool down = false;
    for (const char *at = points; *at; at += at[2] ? 3 : 2) {
        double next[2] = {at[0] - '0', at[1] - '0'}, along[2] = {next[0] - last[0], next[1] - last[1]};
        double length2 = along[0] * along[0] + along[1] * along[1];
        double t = length2 > 0 ? ((x - last[0]) * along[0] + (y - last[1]) * along[1]) / length2 : 0;
        t = fmin(fmax(t, 0), 1);
        bool draws = down && at[0] != '-';
        if (draws) least = fmin(least, hypot(x - last[0] - t * along[0], y - last[1] - t * along[1]));
        down = at[0] != '-';
        memcpy(last, next, sizeof last);
    }
    return least;
}

/* Each of the first 128 characters is its strokes, or nothing. */
static void test_glyphs(void **state) {
    static float inputs[4 * SIDE * SIDE], results[4 * SIDE * SIDE];
    (void)state;
    support_open(&context);
    unsigned random = 3;
    for (int i = 0; i < 4 * SIDE * SIDE; i++) {
        random = random * 1664525u + 1013904223u;
        inputs[i] = i % 4 == 2 ? (float)(i / 4 % SIDE) : (float)((random >> 8) / 16777216.0 * 12 - 4);
    }
    support_evaluate(
        &context,
        "#include \"distance/glyph.glsl\"\nuniform sampler2D inputs;\n"
        "vec4 evaluate(vec2 t) {\n    vec4 a = texelFetch(inputs, ivec2(t), 0);\n"
        "    return vec4(distance_glyph(vec2(a), vec2(0.0), 6.0, int(a.z)),\n"
        "                distance_glyph(vec2(a) / 8.0, vec2(0.125, -0.25), 0.75, 66), 0.0, 0.0);\n}\n",
        inputs, SIDE, SIDE, results);
    double worst = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        double x = (double)inputs[4 * i], y = (double)inputs[4 * i + 1];
        const char *points = points_of((int)inputs[4 * i + 2]);
        double wanted = strokes_away(points, x, y), moved = strokes_away(points_of(66), x - 1, y + 2) / 8;
        if (!*points)
            assert_true(results[4 * i] > 1e12f);
        else
            worst = fmax(worst, fabs((double)results[4 * i] - wanted));
        worst = fmax(worst, fabs((double)results[4 * i + 1] - moved));
    }
    print_message("%d characters, largest error %.1e of a sixth of their height\n", GLYPHS, worst);
    assert_true(worst < 3e-6);
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_lines), cmocka_unit_test(test_wrong_size),
                                       cmocka_unit_test(test_glyphs)};
    return cmocka_run_group_tests_name("distance_lines", tests, support_folder, support_clean);
}
