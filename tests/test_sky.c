/* The paper's sky on the GPU in float, against the same sums written plainly in long double, and against the
 * converged irradiance. */
#include "random.h"
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double degree = 3.14159265358979323846 / 180;
static const long double R = 6360e3L, TOP = 6420e3L, HR = 7994, HM = 1200, BM = 21e-6L, G = 0.76L;
static const long double BR[3] = {5.8e-6L, 13.5e-6L, 33.1e-6L};

#define ATMOSPHERE                                                                                           \
    "#include \"sky/absorber_none.glsl\"\n#include \"sky/paper.glsl\"\n#include "                            \
    "\"sky/view_column_whole.glsl\"\n#include \"sky/sums_add.glsl\"\n"                                       \
    "const Atmosphere air = Atmosphere(6360e3, 60e3, 7994.0, 1200.0, vec3(5.8e-6, 13.5e-6, 33.1e-6), "       \
    "vec3(21e-6),\n"                                                                                         \
    "                                  vec3(23.1e-6), 0.76, vec3(0.0), 25e3, 15e3, vec3(20.0));\n"           \
    "uniform sampler2D inputs;\n"                                                                            \
    "vec3 paper(float h, vec3 view, vec3 sun, int n, int m) {\n"                                             \
    "    return sky_shade(air, sky_paper(air, h, view, sun, n, m), view, sun);\n}\n"

static long double altitude(long double x, long double y, long double z) {
    return sqrtl(x * x + y * y + z * z) - R;
}

/* The first positive root of |p + t d| = radius, or -1. `far` takes the second. */
static long double sphere(const long double p[3], const long double d[3], long double radius, int far) {
    long double b = p[0] * d[0] + p[1] * d[1] + p[2] * d[2];
    long double c = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - radius * radius;
    long double disc = b * b - c;
    if (disc < 0) return -1;
    return far ? -b + sqrtl(disc) : -b - sqrtl(disc);
}

static void add_column(const long double p[3], const long double d[3], long double length, int m,
                       long double out[2]) {
    for (int j = 0; j < m; j++) {
        long double t = (j + 0.5L) * length / m;
        long double h = altitude(p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]);
        out[0] += expl(-h / HR) * length / m;
        out[1] += expl(-h / HM) * length / m;
    }
}

/* The paper's sums as it prints them, plus the planet's shadow. */
static void paper_sky(double height, const double view[3], const double sun[3], int n, int m, double out[3]) {
    long double eye[3] = {0, R + (long double)height, 0}, d[3], s[3], sum_r[3] = {0}, sum_m[3] = {0};
    for (int i = 0; i < 3; i++) d[i] = (long double)view[i], s[i] = (long double)sun[i];
    long double begin = 0, end = sphere(eye, d, TOP, 1), ground = sphere(eye, d, R, 0);
    if (R + (long double)height > TOP) begin = sphere(eye, d, TOP, 0);
    memset(out, 0, 3 * sizeof *out);
    if (end <= 0 || begin < 0) return;
    if (d[1] < 0 && ground >= 0) end = ground;
    long double entry[3], step = (end - begin) / n, nu = d[0] * s[0] + d[1] * s[1] + d[2] * s[2];
    for (int i = 0; i < 3; i++) entry[i] = eye[i] + begin * d[i];
    for (int k = 0; k < n; k++) {
        long double t = begin + (k + 0.5L) * step, p[3], column[2] = {0, 0};
        for (int i = 0; i < 3; i++) p[i] = eye[i] + t * d[i];
        long double along = p[0] * s[0] + p[1] * s[1] + p[2] * s[2];
        long double off = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - along * along;
        if (along < 0 && off < R * R) continue;
        add_column(entry, d, t - begin, m, column);
        add_column(p, s, sphere(p, s, TOP, 1), m, column);
        long double h = altitude(p[0], p[1], p[2]);
        for (int c = 0; c < 3; c++) {
            long double light = expl(-BR[c] * column[0] - 1.1L * BM * column[1]) * step;
            sum_r[c] += light * expl(-h / HR);
            sum_m[c] += light * expl(-h / HM);
        }
    }
    long double pi = acosl(-1), rayleigh = 3 / (16 * pi) * (1 + nu * nu);
    long double mie =
        3 / (8 * pi) * (1 - G * G) * (1 + nu * nu) / ((2 + G * G) * powl(1 + G * G - 2 * G * nu, 1.5L));
    for (int c = 0; c < 3; c++) out[c] = (double)(20 * (sum_r[c] * BR[c] * rayleigh + sum_m[c] * BM * mie));
}

/* Directions as the GPU gets them, in float, so that both sides look the same way. */
static void direction(double elevation, double azimuth, float out[3]) {
    out[0] = (float)(cos(elevation) * sin(azimuth));
    out[1] = (float)sin(elevation);
    out[2] = (float)(cos(elevation) * cos(azimuth));
}

enum { ROWS = 4096 };

static void test_against_long_double(void **state) {
    (void)state;
    static const double heights[] = {0, 0.1, 0.3, 1, 10, 1000, 2e4, 59999, 1e5, 1e6};
    static const double suns[] = {90, 60, 30, 10, 5, 2, 0.1, -2, -6, -12};
    static float inputs[4 * 2 * ROWS], results[4 * 2 * ROWS];
    Context context;
    random_state = 1;
    support_open(&context);
    for (int i = 0; i < ROWS; i++) {
        float *row = inputs + 8 * i;
        double low = i % 3 == 0 ? 0.02 : 1.5, up = (2 * random_unit() - (i % 2 ? 1 : 0.1)) * low;
        row[3] = (float)heights[i % 10];
        direction(up > 1.5707 ? 1.5707 : up, 6.28 * random_unit(), row);
        direction(suns[(i / 10) % 10] * degree, 0, row + 4);
    }
    support_evaluate(
        &context,
        ATMOSPHERE
        "vec4 evaluate(vec2 t) {\n"
        "    ivec2 at = ivec2(int(t.x) / 2 * 2, int(t.y));\n"
        "    vec4 view = texelFetch(inputs, at, 0), sun = texelFetch(inputs, at + ivec2(1, 0), 0);\n"
        "    return vec4(paper(view.w, view.xyz, sun.xyz, 16, 4), 1);\n}",
        inputs, 2 * 64, ROWS / 64, results);
    double squares = 0, worst = 0;
    int flips = 0;
    for (int i = 0; i < ROWS; i++) {
        double view[3], sun[3], expected[3];
        for (int c = 0; c < 3; c++)
            view[c] = (double)inputs[8 * i + c], sun[c] = (double)inputs[8 * i + 4 + c];
        paper_sky((double)inputs[8 * i + 3], view, sun, 16, 4, expected);
        for (int c = 0; c < 3; c++) {
            double got = (double)results[8 * i + c];
            assert_true(isfinite(got) && got >= 0);
            double error = fabs(got - expected[c]) / fmax(expected[c], 1.4e-6);
            /* One of the 16 points may stand on the shadow's edge or a tangent ray graze the ground, where
             * float and long double rightly disagree; rare, and not counted in the errors. */
            if (error > 1e-3) {
                flips += c == 0;
                continue;
            }
            squares += error * error / (3.0 * ROWS);
            worst = fmax(worst, error);
        }
    }
    print_message("float against long double: RMS %.2e, largest %.2e, %d of %d rays on an edge\n",
                  sqrt(squares), worst, flips, ROWS);
    assert_true(sqrt(squares) < 1e-5 && worst < 1e-3 && flips < ROWS / 500);
    context_close(&context);
}

/* Sky irradiance on the ground by 16x4 sums, a share of the converged one. */
static void irradiance(const Context *context, double sun_deg, double out[3]) {
    enum { SIDE = 256 };
    static float results[4 * SIDE * SIDE];
    char glsl[2048];
    float sun[3];
    direction(sun_deg * degree, 0, sun);
    snprintf(glsl, sizeof glsl,
             ATMOSPHERE "vec4 evaluate(vec2 t) {\n"
                        "    vec2 u = (t + 0.5) / 256.0;\n"
                        "    float c = sqrt(u.x), s = sqrt(1.0 - u.x), phi = 2.0 * PI * u.y;\n"
                        "    vec3 view = vec3(s * sin(phi), c, s * cos(phi));\n"
                        "    return vec4(PI * paper(1.0, view, vec3(%.9g, %.9g, %.9g), 16, 4), 1);\n}",
             (double)sun[0], (double)sun[1], (double)sun[2]);
    support_evaluate(context, glsl, NULL, SIDE, SIDE, results);
    memset(out, 0, 3 * sizeof *out);
    for (int i = 0; i < SIDE * SIDE; i++) {
        for (int c = 0; c < 3; c++) out[c] += (double)results[4 * i + c] / (SIDE * SIDE);
    }
}

static void test_darkening(void **state) {
    (void)state;
    static const double converged90[3] = {0.827788824, 1.22681632, 1.92601124}; /* data/irradiance.csv */
    static const double converged30[3] = {0.74108465, 1.06504174, 1.52084062};
    static const double darker90[3] = {16.3, 10.0, 4.5}, darker30[3] = {14, 8, 1};
    double got[3];
    Context context;
    support_open(&context);
    irradiance(&context, 90, got);
    for (int c = 0; c < 3; c++) {
        double darker = 100 * (1 - got[c] / converged90[c]);
        print_message("sun 90, channel %d: %.2f %% darker\n", c, darker);
        assert_true(fabs(darker - darker90[c]) < 0.3);
    }
    irradiance(&context, 30, got);
    for (int c = 0; c < 3; c++) assert_true(fabs(100 * (1 - got[c] / converged30[c]) - darker30[c]) < 1);
    context_close(&context);
}

/* Twilight: the planet's shadow covers the zenith with the sun below -7.84 degrees and all of the sky below
 * -15.7. */
static void test_shadow(void **state) {
    (void)state;
    static float results[4 * 64 * 64];
    static const struct {
        double sun, lowest_view;
        int lit;
    } cases[] = {{-7.7, 90, 1}, {-8, 90, 0}, {-8, 1, 1}, {-15.5, 0.02, 1}, {-15.8, 0.02, 0}, {-18, 0.02, 0}};
    Context context;
    support_open(&context);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char glsl[2048];
        float sun[3];
        double sum = 0;
        direction(cases[i].sun * degree, 0, sun);
        /* From the lowest view up to the zenith in the sun's azimuth, with samples enough to find a thin lit
         * part. */
        snprintf(glsl, sizeof glsl,
                 ATMOSPHERE "vec4 evaluate(vec2 t) {\n"
                            "    float e = radians(mix(%.4f, 90.0, (t.x + 64.0 * t.y) / 4095.0));\n"
                            "    vec3 view = vec3(0.0, sin(e), cos(e));\n"
                            "    return vec4(paper(0.0, view, vec3(%.9g, %.9g, %.9g), 4096, 4), 1);\n}",
                 cases[i].lowest_view, (double)sun[0], (double)sun[1], (double)sun[2]);
        support_evaluate(&context, glsl, NULL, 64, 64, results);
        for (int k = 0; k < 64 * 64; k++) sum += (double)results[4 * k + 2];
        if ((sum > 0) != cases[i].lit)
            fail_msg("sun %g, views from %g: %g", cases[i].sun, cases[i].lowest_view, sum);
    }
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_against_long_double),
        cmocka_unit_test(test_darkening),
        cmocka_unit_test(test_shadow),
    };
    return cmocka_run_group_tests_name("sky", tests, support_folder, support_clean);
}
