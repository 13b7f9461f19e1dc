/* Fractals as distance fields: beside a search over the cubes of a sponge, no steeper than they say, below
 * the distance to places on their surfaces, and empty as far as they say.
 */
#include "points.h"
#include "random.h"
#include "support.h"

#include <math.h>
#include <stdio.h>

enum { WIDTH = 256, HEIGHT = 128, ITEMS = WIDTH * HEIGHT / 2 };

/* Two points for each item. */
static float inputs[8 * ITEMS], results[8 * ITEMS];
static Context context;

/* Points within `reach` of the origin, each with another one that is nearer than 0.3 by up to four powers of
 * ten. */
static void make_points(double reach) {
    random_state = 5;
    points_make(inputs, ITEMS, reach, 0.3, 4);
}

#define FILE_OF(name) "#include \"distance/" name ".glsl\"\n"

/* `body` sets c by the points p and q and the field. */
static void evaluate(const char *field, const char *body) {
    char declarations[1024];
    snprintf(declarations, sizeof declarations,
             FILE_OF("apollonian") FILE_OF("julia") FILE_OF("mandelbulb")
                 FILE_OF("menger") "float field(vec3 p) { return %s; }\n",
             field);
    points_evaluate(&context, declarations, body, inputs, WIDTH, HEIGHT, results);
}

typedef struct Fractal {
    const char *field;
    double steepness; /* as the file says */
    bool solid;       /* the origin is inside or not, and what is negative is solid */
} Fractal;

static const Fractal fractals[] = {
    {"distance_menger(p, vec3(0.0), 1.0, 1)", 1, true},
    {"distance_menger(p, vec3(0.0), 1.0, 4)", 1, true},
    {"distance_menger(p, vec3(0.1, -0.2, 0.3), 0.7, 6)", 1, true},
    {"distance_mandelbulb(p, 4.0, 4)", 1.1, true},
    {"distance_mandelbulb(p, 8.0, 2)", 1.1, true},
    {"distance_mandelbulb(p, 8.0, 4)", 1.1, true},
    {"distance_mandelbulb(p, 15.0, 3)", 1.1, true},
    {"distance_julia(p, vec4(-0.2, 0.6, 0.2, 0.2), 6)", 1, true},
    {"distance_julia(p, vec4(-0.2, 0.6, 0.2, 0.2), 12)", 1, true},
    {"distance_julia(p, vec4(-1.0, 0.2, 0.0, 0.0), 9)", 1, true},
    {"distance_julia(p, vec4(-0.125, -0.256, 0.847, 0.0895), 9)", 1, true},
    {"distance_apollonian(p, 1.1, 8)", 1, false},
    {"distance_apollonian(p, 1.25, 4)", 1, false},
    {"distance_apollonian(p, 1.5, 10)", 1, false},
};
enum { FRACTALS = sizeof fractals / sizeof *fractals };

/* The bound is that of real numbers; the points are at least 1e-5 apart, and floats of 2 differ by 2e-7. */
static void test_steepness(void **state) {
    (void)state;
    support_open(&context);
    make_points(2);
    for (int k = 0; k < FRACTALS; k++) {
        double steepest = 0;
        int outside = 0;
        evaluate(fractals[k].field, "c = vec4(field(p), field(q), distance(p, q), 0.0);");
        for (int i = 0; i < ITEMS; i++) {
            const float *r = results + 8 * i;
            assert_true(isfinite(r[0]) && isfinite(r[1]));
            if (r[0] < 0 || r[1] < 0 || r[2] < 1e-5F) continue;
            outside++;
            steepest = fmax(steepest, (fabs((double)(r[0] - r[1])) - 2e-6) / (double)r[2]);
        }
        print_message("%s: steepness to %.3f in %d pairs\n", fractals[k].field, steepest, outside);
        assert_true(outside > ITEMS / 2 && steepest < fractals[k].steepness * 1.0005 && steepest > 0.2);
    }
    context_close(&context);
}

/* From p toward q in shortened steps: where the walk meets the surface, the field at another item's point is
 * at most the distance to there. A place at random within the distance is not solid. */
static void test_below_distance(void **state) {
    (void)state;
    support_open(&context);
    make_points(1.6);
    for (int k = 0; k < FRACTALS; k++) {
        static double found[4096][3];
        int count = 0, solid = 0;
        double most = 0;
        evaluate(fractals[k].field,
                 "vec3 w = normalize(q - p); vec3 s = p; float d = field(p), first = d;\n"
                 "for (int i = 0; i < 300; i++) { s += max(0.7 * d, 0.0) * w; d = field(s); }\n"
                 "c = int(t.x) % 2 == 0 ? vec4(s, d) : vec4(first, field(p + 0.999 * max(first, 0.0) * w), "
                 "0.0, 0.0);");
        for (int i = 0; i < ITEMS && count < 4096; i++) {
            const float *r = results + 8 * i;
            solid += r[4] > 0 && r[5] < -1e-6F;
            if (r[4] < 0 || fabs(r[3]) > 1e-4 || !(hypot(hypot(r[0], r[1]), r[2]) < 3)) continue;
            for (int c = 0; c < 3; c++) found[count][c] = (double)r[c];
            count++;
        }
        for (int i = 0; i < 1024; i++) {
            double d = (double)results[8 * i + 4], nearest = INFINITY;
            for (int j = 0; j < count; j++) {
                double x = found[j][0] - (double)inputs[8 * i], y = found[j][1] - (double)inputs[8 * i + 1],
                       z = found[j][2] - (double)inputs[8 * i + 2];
                nearest = fmin(nearest, sqrt(x * x + y * y + z * z));
            }
            if (d > 1e-3) most = fmax(most, (d - 2e-4) / nearest);
        }
        print_message(
            "%s: %d places of the surface, the field is up to %.3f of the distance to one; %d solid\n",
            fractals[k].field, count, most, solid);
        assert_true(count > 500 && solid == 0 && most <= 1 && most > 0.1);
    }
    context_close(&context);
}

/* Whether the cube of a sponge of two levels with this place in a grid of 9 is left. */
static bool left(const int *at) {
    for (int third = 1; third <= 3; third += 2) {
        int middle = 0;
        for (int c = 0; c < 3; c++) middle += at[c] / third % 3 == 1;
        if (middle >= 2) return false;
    }
    return true;
}

static double searched(const float *p, bool *inside) {
    double nearest = INFINITY;
    for (int k = 0; k < 729; k++) {
        int at[3] = {k % 9, k / 9 % 9, k / 81};
        double square = 0;
        if (!left(at)) continue;
        for (int c = 0; c < 3; c++) {
            double over = fmax(fabs((double)p[c] - (2 * at[c] - 8) / 9.0) - 1 / 9.0, 0);
            square += over * over;
        }
        nearest = fmin(nearest, sqrt(square));
    }
    *inside = nearest <= 0;
    return nearest;
}

/* The sponge is exact outside, and solid where a cube is left. */
static void test_sponge(void **state) {
    (void)state;
    support_open(&context);
    make_points(1.3);
    evaluate("distance_menger(p, vec3(0.0), 1.0, 2)", "c = vec4(field(p));");
    double worst = 0;
    int inside = 0, wrong = 0;
    for (int i = 0; i < ITEMS; i++) {
        bool solid = false;
        double expected = searched(inputs + 8 * i, &solid), d = (double)results[8 * i];
        inside += solid;
        wrong += fabs(d) > 1e-6 && (d < 0) != solid;
        if (!solid) worst = fmax(worst, fabs(d - expected));
    }
    print_message("a sponge: %d of %d inside, %d on the wrong side, largest error outside %.1e\n", inside,
                  ITEMS, wrong, worst);
    assert_true(inside > ITEMS / 10 && wrong == 0 && worst < 1e-6);
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_steepness),
                                       cmocka_unit_test(test_below_distance), cmocka_unit_test(test_sponge)};
    return cmocka_run_group_tests_name("distance_fractal", tests, support_folder, support_clean);
}
