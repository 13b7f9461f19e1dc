/* Operators on distances: where two surfaces at right angles are joined, the outline is the one that is said;
 * deformed and repeated solids are those said otherwise; and nothing changes faster than it says.
 */
#include "points.h"
#include "random.h"
#include "support.h"

#include <math.h>
#include <stdio.h>

enum { WIDTH = 64, HEIGHT = 32, ITEMS = WIDTH * HEIGHT / 2 };

/* Two points and a number for each item. */
static float inputs[8 * ITEMS], results[8 * ITEMS];
static Context context;
static const double PI2 = 6.283185307179586;

/* Points within `reach` of the origin, each with another one at most `step` away. */
static void make_points(double reach, double step) {
    random_state = 11;
    points_make(inputs, ITEMS, reach, step, 0);
}

#define FILE_OF(name) "#include \"distance/" name ".glsl\"\n"

/* `body` sets c by the points p and q. */
static void evaluate(const char *declarations, const char *body) {
    static char all[8192];
    snprintf(all, sizeof all,
             FILE_OF("boolean") FILE_OF("box") FILE_OF("deform") FILE_OF("join") FILE_OF("mirror")
                 FILE_OF("move") FILE_OF("repeat") FILE_OF("repeat_polar") FILE_OF("repeat_random")
                     FILE_OF("share") FILE_OF("smooth") FILE_OF("smooth_kinds") FILE_OF("sphere") "%s",
             declarations);
    points_evaluate(&context, all, body, inputs, WIDTH, HEIGHT, results);
}

static void start(void **state) {
    (void)state;
    support_open(&context);
}

typedef struct Pair {
    double a, b;
} Pair;

static Pair chamfer(double t) {
    return (Pair){0.4 * t, 0.4 * (1 - t)};
}

/* Five treads and rises of 0.08. */
static Pair stairs(double t) {
    double place = fmin(9.999999 * t, 9.999999), step = floor(place / 2), along = place - 2 * step;
    return (Pair){0.08 * (step + fmax(along - 1, 0)), 0.4 - 0.08 * (step + fmin(along, 1))};
}

/* Three half columns on the chamfer, whose length is 0.4 sqrt(2). Where two of them touch, the gap between
 * them is too narrow to look beside. */
static Pair columns(double t) {
    double radius = 0.4 * sqrt(2) / 6, place = fmin(3 * t, 2.999999), which = floor(place);
    double angle = 0.4 * PI2 * (place - which - 0.5), x = radius * cos(angle);
    double y = radius * (2 * which - 2) + radius * sin(angle);
    return (Pair){0.2 + (x - y) * sqrt(0.5), 0.2 + (x + y) * sqrt(0.5)};
}

static Pair circular(double t) {
    return (Pair){0.4 - 0.4 * sin(PI2 / 4 * t), 0.4 - 0.4 * cos(PI2 / 4 * t)};
}

/* The product of both is a quarter of k squared. */
static Pair hyperbola(double t) {
    return (Pair){0.2 * exp(4 * t - 2), 0.2 * exp(2 - 4 * t)};
}

static Pair pipe(double t) {
    return (Pair){0.4 * cos(PI2 * t), 0.4 * sin(PI2 * t)};
}

static Pair notch(double t) {
    return (Pair){fabs(0.8 * t - 0.4) - 0.4, 0.8 * t - 0.4};
}

static Pair groove(double t) {
    double place = 3 * t - 1;
    return (Pair){place < 0   ? 0.3 * t * -3
                  : place > 1 ? -0.3 * (2 - place)
                              : -0.3,
                  0.2 * fmin(fmax(2 * place - 1, -1), 1)};
}

static Pair tongue(double t) {
    return (Pair){-groove(t).a, groove(t).b};
}

static const struct Join {
    const char *expression; /* of a and b */
    Pair (*outline)(double t);
    bool steep;            /* up to JOIN_STEEPNESS, where the surfaces are not at right angles */
    double sign_a, sign_b; /* an intersection and a subtraction are the union turned inside out */
} joins[] = {
    {"op_chamfer_union(a, b, 0.4)", chamfer, true, 1, 1},
    {"op_chamfer_intersection(a, b, 0.4)", chamfer, true, -1, -1},
    {"op_chamfer_subtraction(a, b, 0.4)", chamfer, true, -1, 1},
    {"op_stairs_union(a, b, 0.4, 5.0)", stairs, false, 1, 1},
    {"op_stairs_intersection(a, b, 0.4, 5.0)", stairs, false, -1, -1},
    {"op_stairs_subtraction(a, b, 0.4, 5.0)", stairs, false, -1, 1},
    {"op_columns_union(a, b, 0.4, 3.0)", columns, true, 1, 1},
    {"op_columns_intersection(a, b, 0.4, 3.0)", columns, true, -1, -1},
    {"op_columns_subtraction(a, b, 0.4, 3.0)", columns, true, -1, 1},
    {"op_smooth_union_circular(a, b, 0.4)", circular, false, 1, 1},
    {"op_smooth_intersection_circular(a, b, 0.4)", circular, false, -1, -1},
    {"op_smooth_subtraction_circular(a, b, 0.4)", circular, false, -1, 1},
    {"op_smooth_union_root(a, b, 0.4)", hyperbola, false, 1, 1},
    {"op_smooth_intersection_root(a, b, 0.4)", hyperbola, false, -1, -1},
    {"op_smooth_subtraction_root(a, b, 0.4)", hyperbola, false, -1, 1},
    {"op_pipe(a, b, 0.4)", pipe, true, 1, 1},
    {"op_engrave(a, b, 0.4)", notch, true, 1, 1},
    {"op_groove(a, b, 0.3, 0.2)", groove, false, 1, 1},
    {"op_tongue(a, b, 0.3, 0.2)", tongue, false, 1, 1},
};
enum { JOINS = sizeof joins / sizeof *joins };

/* The field is 0 on the outline, and just beside it is less on one side than on the other, which no field
 * does that is 0 all over. */
static void test_outlines(void **state) {
    start(state);
    for (int k = 0; k < JOINS; k++) {
        char declarations[512];
        double worst = 0, least_rise = 1e30;
        for (int i = 0; i < ITEMS; i++) {
            Pair at = joins[k].outline((i + 0.5) / ITEMS);
            inputs[8 * i] = (float)(joins[k].sign_a * at.a),
                       inputs[8 * i + 1] = (float)(joins[k].sign_b * at.b);
        }
        snprintf(declarations, sizeof declarations, "float field(float a, float b) { return %s; }\n",
                 joins[k].expression);
        evaluate(declarations,
                 "c.x = field(p.x, p.y);\n    c.y = -1.0;\n    c.z = 1.0;\n"
                 "    for (int i = 0; i < 8; i++) {\n"
                 "        vec2 beside = p.xy + 0.001 * vec2(cos(0.785398 * float(i)), sin(0.785398 * "
                 "float(i)));\n"
                 "        c.y = max(c.y, field(beside.x, beside.y));\n"
                 "        c.z = min(c.z, field(beside.x, beside.y));\n    }\n");
        for (int i = 0; i < ITEMS; i++) {
            const float *c = results + 8 * i;
            worst = fmax(worst, fabs((double)c[0]));
            least_rise = fmin(least_rise, fmin((double)c[1], -(double)c[2]));
        }
        print_message("%s: on its outline at most %.1e, beside it at least %.1e\n", joins[k].expression,
                      worst, least_rise);
        assert_true(worst < 5e-7 && least_rise > 1e-4);
    }
    context_close(&context);
}

/* The greatest change of `expression` of a and b, two distances. */
static double steepest(const char *expression, const char *a, const char *b) {
    char declarations[1024];
    double most = 0;
    snprintf(declarations, sizeof declarations, "float field(vec3 p) { float a = %s, b = %s; return %s; }\n",
             a, b, expression);
    evaluate(declarations, "c.x = (field(q) - field(p)) / length(q - p);\n    c.y = JOIN_STEEPNESS;\n");
    for (int i = 0; i < ITEMS; i++) most = fmax(most, fabs((double)results[8 * i]));
    return most;
}

static void test_steepness_of_joins(void **state) {
    start(state);
    for (int k = 0; k < JOINS; k++) {
        make_points(0.7, 0.02);
        double square = steepest(joins[k].expression, "p.x", "p.y");
        /* A subtraction is steepest where the surfaces face each other. */
        double aslant =
            steepest(joins[k].expression, "distance_sphere(p, vec3(0.1, 0.2, -0.1), 0.5)",
                     joins[k].sign_a == joins[k].sign_b ? "distance_box(p, vec3(0.0), vec3(0.4, 0.3, 0.5))"
                                                        : "-distance_box(p, vec3(0.0), vec3(0.4, 0.3, 0.5))");
        print_message("%s: steepness %.4f at right angles, %.4f elsewhere\n", joins[k].expression, square,
                      aslant);
        assert_true(square < 1.0005 && square > 0.9);
        /* What is said to be steep is. */
        double said = joins[k].steep ? (double)results[1] : 1;
        assert_true(aslant < said + 5e-4 && aslant > 0.95 * said);
    }
    context_close(&context);
}

/* How fast a deformed point moves, beside what is said, within a radius of 0.8 of the axis. */
static void test_deformed(void **state) {
    static const struct {
        const char *name, *point, *steepness, *axis, *rim;
    } cases[] = {
        {"twist", "op_twist(p, 2.5)", "op_twist_steepness(2.5, 0.8)", "vec2(p.x, p.z)",
         "p * vec3(0.8 / reach, 1.0, 0.8 / reach)"},
        {"twist back", "op_twist(p, -0.5)", "op_twist_steepness(-0.5, 0.8)", "vec2(p.x, p.z)",
         "p * vec3(0.8 / reach, 1.0, 0.8 / reach)"},
        {"bend", "op_bend(p, -1.5)", "op_bend_steepness(-1.5, 0.8)", "vec2(p.x, p.y)",
         "p * vec3(0.8 / reach, 0.8 / reach, 1.0)"},
        {"taper", "op_taper(p, -0.5, 0.6, 0.4)", "op_taper_steepness(-0.5, 0.6, 0.4, 0.8)", "vec2(p.x, p.z)",
         "p * vec3(0.8 / reach, 1.0, 0.8 / reach)"},
        {"taper out", "op_taper(p, -0.5, 0.6, 1.8)", "op_taper_steepness(-0.5, 0.6, 1.8, 0.8)",
         "vec2(p.x, p.z)", "p * vec3(0.8 / reach, 1.0, 0.8 / reach)"},
    };
    start(state);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char declarations[1024], body[1024];
        double most = 0;
        int counted = 0;
        make_points(0.8, 0.01);
        snprintf(
            declarations, sizeof declarations,
            "vec3 moved(vec3 p) { return %s; }\nfloat off(vec3 p) { return length(%s); }\n"
            "vec3 along(vec3 p, vec3 h) { return (moved(p + 0.004 * h) - moved(p - 0.004 * h)) / 0.008; }\n",
            cases[k].point, cases[k].axis);
        /* All points are put onto the rim, where the stretch is longest. The longest stretch is the root of
         * the largest eigenvalue. */
        snprintf(body, sizeof body,
                 "float reach = off(p);\n    vec3 rim = %s;\n"
                 "    mat3 change = mat3(along(rim, vec3(1, 0, 0)), along(rim, vec3(0, 1, 0)), along(rim, "
                 "vec3(0, 0, 1)));\n"
                 "    vec3 v = vec3(0.6, 0.5, 0.4);\n"
                 "    for (int i = 0; i < 60; i++) v = normalize(transpose(change) * (change * v));\n"
                 "    c = vec4(length(change * v), %s, off(rim), 0.0);\n",
                 cases[k].rim, cases[k].steepness);
        evaluate(declarations, body);
        for (int i = 0; i < ITEMS; i++) {
            const float *c = results + 8 * i;
            if (c[2] > 0.80001f) continue;
            counted++;
            most = fmax(most, (double)c[0]);
        }
        print_message("%s: steepness to %.4f of %.4f\n", cases[k].name, most, (double)results[1]);
        assert_true(counted > ITEMS / 2 && most < (double)results[1] * 1.0005 &&
                    most > 0.985 * (double)results[1]);
    }
    context_close(&context);
}

/* Beside the same solid said otherwise: `most` is how far they may differ, and the field's steepness is at
 * most 1. */
static void test_same(void **state) {
    static const struct {
        const char *name, *got, *expected;
        bool steady;
    } cases[] = {
        {"twist", "ONE(op_twist(p, 2.5))", "ONE(op_rotate(p, vec3(0.0, 1.0, 0.0), 2.5 * p.y))", false},
        {"bend", "ONE(op_bend(p, 0.3))", "ONE(op_rotate(p, vec3(0.0, 0.0, 1.0), 0.3 * p.x))", false},
        {"taper below", "ONE(op_taper(p, 1.5, 2.0, 0.4))", "ONE(p)", true},
        {"taper above", "ONE(op_taper(p, -2.0, -1.5, 0.5))", "ONE(p * vec3(2.0, 1.0, 2.0))", false},
        {"mirror", "ONE(op_mirror(p, vec3(0.6, 0.0, 0.8), -0.2))",
         "min(ONE(p), ONE(p - 2.0 * (dot(p, vec3(0.6, 0.0, 0.8)) + 0.2) * vec3(0.6, 0.0, 0.8)))", true},
        {"7 around", "min(ONE(repeat_polar(p, 7.0, 0)), ONE(repeat_polar(p, 7.0, 1)))", "around(p, 7)", true},
        {"2 around", "min(ONE(repeat_polar(p, 2.0, 0)), ONE(repeat_polar(p, 2.0, 1)))", "around(p, 2)", true},
        {"1 around", "min(ONE(repeat_polar(p, 1.0, 0)), ONE(repeat_polar(p, 1.0, 1)))", "ONE(p)", true},
        {"random copies", "scattered(p)", "min(all_scattered(p), 0.25)", true},
    };
    /* ONE lies toward x, within a seventh of the circle, and is not its own mirror image. */
    static const char *declarations =
        "#define ONE(p) distance_box(op_rotate(p - vec3(0.8, 0.1, 0.05), vec3(0.48, 0.6, 0.64), 0.7), "
        "vec3(0.0), "
        "vec3(0.2, 0.3, 0.1))\n"
        "float around(vec3 p, int n) { float d = 1e30;\n"
        "    for (int i = 0; i < n; i++) d = min(d, ONE(op_rotate(p, vec3(0.0, 1.0, 0.0), float(i) * "
        "6.28318531 / "
        "float(n))));\n    return d;\n}\n"
        "const vec3 SPACING = vec3(0.5, 0.0, 0.7);\n"
        "float ball(vec3 p, vec3 index) {\n    vec3 random = repeat_random(index, 1u);\n"
        "    return distance_sphere(p, 0.2 * (random - 0.5), 0.05 + 0.1 * random.x);\n}\n"
        "float scattered(vec3 p) { float d = repeat_reach(SPACING);\n    for (int i = 0; i < 4; i++)\n"
        "        d = min(d, ball(repeat_cell(p, SPACING, vec3(0.0), i), repeat_index(p, SPACING, vec3(0.0), "
        "i)));\n"
        "    return d;\n}\n"
        "float all_scattered(vec3 p) { float d = 1e30;\n"
        "    for (int x = -5; x <= 5; x++) for (int z = -5; z <= 5; z++)\n"
        "        d = min(d, ball(p - SPACING * vec3(x, 0, z), vec3(x, 0, z)));\n    return d;\n}\n";
    start(state);
    make_points(1.4, 0.02);
    /* Half of the points are near ONE. */
    for (int i = 0; i < ITEMS; i += 2) {
        for (int c = 0; c < 8; c++) inputs[8 * i + c] *= 0.3f;
        inputs[8 * i] += 0.8f, inputs[8 * i + 4] += 0.8f;
    }
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char all[4096];
        double worst = 0, steep = 0;
        int inside = 0;
        snprintf(all, sizeof all,
                 "%s\nfloat got(vec3 p) { return %s; }\nfloat expected(vec3 p) { return %s; }\n",
                 declarations, cases[k].got, cases[k].expected);
        evaluate(all, "c = vec4(got(p), expected(p), (got(q) - got(p)) / length(q - p), 0.0);\n");
        for (int i = 0; i < ITEMS; i++) {
            const float *c = results + 8 * i;
            worst = fmax(worst, fabs((double)c[0] - (double)c[1]));
            steep = fmax(steep, fabs((double)c[2]));
            inside += c[0] < 0;
        }
        print_message("%s: %d inside, largest error %.1e, steepness to %.4f\n", cases[k].name, inside, worst,
                      steep);
        assert_true(inside > 4 && worst < 2e-6 && (!cases[k].steady || steep < 1.0005));
    }
    context_close(&context);
}

/* A ball with bumps: as high as said over each direction, and never steeper than a metre a metre. */
static void test_displaced(void **state) {
    start(state);
    make_points(1.4, 0.01);
    double steep = 0, worst = 0;
    evaluate(
        "float bumps(vec3 p) { return 0.05 * sin(9.0 * p.x) * sin(9.0 * p.y) * sin(9.0 * p.z); }\n"
        "float field(vec3 p) { return op_displace(distance_sphere(p, vec3(0.0), 0.8), bumps(p), 0.45); }\n",
        "c = vec4((field(q) - field(p)) / length(q - p),\n"
        "             field(p) * 1.45 - (length(p) - 0.8 - bumps(p)), 0.0, 0.0);\n");
    for (int i = 0; i < ITEMS; i++) {
        steep = fmax(steep, fabs((double)results[8 * i]));
        worst = fmax(worst, fabs((double)results[8 * i + 1]));
    }
    print_message("bumps: steepness to %.4f, largest error %.1e\n", steep, worst);
    assert_true(steep < 1.0005 && steep > 0.8 && worst < 2e-6);
    context_close(&context);
}

/* The share of the second solid is the derivative of the joined distance by its own, and a share of the first
 * solid is what is left. */
static void test_shares(void **state) {
    static const char *const kinds[] = {"smooth_union", "smooth_union_circular", "smooth_union_root"};
    start(state);
    make_points(1, 1);
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        char body[1024];
        double worst = 0, odd = 0, least = 1, most = 0;
        snprintf(body, sizeof body,
                 "float k = 0.7, h = 0.004;\n"
                 "    c.x = (op_%s(p.x, p.y + h, k) - op_%s(p.x, p.y - h, k)) / (2.0 * h);\n"
                 "    c.y = share_%s(p.x, p.y, k);\n    c.z = share_%s(p.y, p.x, k);\n"
                 "    c.w = share_%s(p.x, p.y, 0.0) - share_union(p.x, p.y);\n",
                 kinds[k], kinds[k], kinds[k], kinds[k], kinds[k]);
        evaluate("", body);
        for (int i = 0; i < ITEMS; i++) {
            const float *c = results + 8 * i;
            worst = fmax(worst, fabs((double)c[0] - (double)c[1]));
            odd = fmax(odd, fabs((double)c[1] + (double)c[2] - 1));
            least = fmin(least, (double)c[1]), most = fmax(most, (double)c[1]);
            assert_true(fabs((double)c[3]) < 1e-6);
        }
        print_message("%s: the share differs by %.1e from the derivative, and is %.3f to %.3f\n", kinds[k],
                      worst, least, most);
        assert_true(worst < 4e-3 && odd < 1e-6 && least < 0.1 && least >= 0 && most > 0.9 && most <= 1);
    }
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_outlines),  cmocka_unit_test(test_steepness_of_joins),
        cmocka_unit_test(test_deformed),  cmocka_unit_test(test_same),
        cmocka_unit_test(test_displaced), cmocka_unit_test(test_shares)};
    return cmocka_run_group_tests_name("distance_join", tests, support_folder, support_clean);
}
