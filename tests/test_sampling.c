/* Random numbers, lobes and phase functions: on the GPU, against what they promise. */
#include "support.h"

#include <math.h>
#include <stdio.h>

enum { SIDE = 512, TEXELS = SIDE * SIDE };

static float results[4 * TEXELS];

/* Mean and its standard error of a function of the four results. */
static void mean_of(double (*function)(const float *), double *mean, double *standard_error) {
    double sum = 0, squares = 0;
    for (int i = 0; i < TEXELS; i++) {
        double value = function(results + 4 * i);
        sum += value;
        squares += value * value;
    }
    *mean = sum / TEXELS;
    *standard_error = sqrt((squares / TEXELS - *mean * *mean) / TEXELS);
}

static void expect_mean(const char *what, double (*function)(const float *), double expected) {
    double mean, standard_error;
    mean_of(function, &mean, &standard_error);
    if (fabs(mean - expected) > 4 * standard_error + 1e-6) {
        fail_msg("%s: mean %.6f +- %.6f, expected %.6f", what, mean, standard_error, expected);
    }
}

/* Chi-square of counts against equal shares, as standard deviations from its expectation (Wilson and
 * Hilferty). */
static double chi_square_deviations(const int *counts, int bins, double expected) {
    double chi2 = 0, degrees = bins - 1;
    for (int i = 0; i < bins; i++) chi2 += (counts[i] - expected) * (counts[i] - expected) / expected;
    return (cbrt(chi2 / degrees) - (1 - 2 / (9 * degrees))) / sqrt(2 / (9 * degrees));
}

static double component_x(const float *v) {
    return v[0];
}

static double component_y(const float *v) {
    return v[1];
}

static double product_xy(const float *v) {
    return (v[0] - 0.5) * (v[1] - 0.5);
}

/* Two pairs of one sample, and pairs of neighbouring pixels and samples, are uniform and independent. */
static void test_random(void **state) {
    (void)state;
    static const char *const draws[] = {
        /* the first two pairs of a pixel's sample */
        "Sequence s = sequence_start(uint(t.x), uint(t.y), 5u, 1u); vec2 a = sequence_pair(s); vec2 b = "
        "sequence_pair(s);",
        /* one pixel, many samples, beyond 2^24 too */
        "Sequence s = sequence_start(7u, 9u, uint(t.x) + 512u * uint(t.y) + 16777000u, 1u);"
        "vec2 a = sequence_pair(s); vec2 b = sequence_pair(s);",
        /* the same sample of neighbours */
        "Sequence s = sequence_start(uint(t.x), uint(t.y), 0u, 0u); vec2 a = sequence_pair(s);"
        "Sequence q = sequence_start(uint(t.x) + 1u, uint(t.y), 0u, 0u); vec2 b = sequence_pair(q);",
        /* the same pixel under neighbouring seeds */
        "Sequence s = sequence_start(uint(t.x), uint(t.y), 0u, 4u); vec2 a = sequence_pair(s);"
        "Sequence q = sequence_start(uint(t.x), uint(t.y), 0u, 5u); vec2 b = sequence_pair(q);",
    };
    static const char *const methods[] = {"random", "sobol", "additive"};
    Context context;
    support_open(&context);
    for (size_t k = 0; k < 3 * (sizeof draws / sizeof *draws); k++) {
        size_t d = k / 3;
        char glsl[1024];
        int squares[1024] = {0}, cross[1024] = {0};
        snprintf(glsl, sizeof glsl,
                 "#include \"math/dialect.glsl\"\n#include \"sequence/%s.glsl\"\n"
                 "vec4 evaluate(vec2 t) { %s return vec4(a, b); }",
                 methods[k % 3], draws[d]);
        support_evaluate(&context, glsl, NULL, SIDE, SIDE, results);
        expect_mean("x", component_x, 0.5);
        expect_mean("y", component_y, 0.5);
        expect_mean("xy", product_xy, 0);
        for (int i = 0; i < TEXELS; i++) {
            const float *v = results + 4 * i;
            for (int c = 0; c < 4; c++) assert_true(v[c] >= 0 && v[c] < 1);
            squares[(int)(v[0] * 32) * 32 + (int)(v[1] * 32)]++;
            cross[(int)(v[0] * 32) * 32 + (int)(v[2] * 32)]++;
        }
        double pair = chi_square_deviations(squares, 1024, TEXELS / 1024.0);
        double pairs = chi_square_deviations(cross, 1024, TEXELS / 1024.0);
        /* One pixel's points are more even than chance, Sobol's in a pair, the recurrence's in any: only too
         * uneven is a fault there. */
        bool even = k % 3 > 0 && d == 1;
        if (pair > 4 || (!even && pair < -4) || pairs > 4 || (!even && pairs < -4)) {
            fail_msg("%s, %s: %.1f in a pair, %.1f across", methods[k % 3], draws[d], pair, pairs);
        }
    }
    context_close(&context);
}

/* Sobol: in every aligned run of 256 samples of a pixel, each pair has one point in each elementary interval.
 */
static void test_elementary_intervals(void **state) {
    (void)state;
    static const int columns[] = {1, 2, 4, 8, 16, 32, 64, 128, 256};
    static const unsigned starts[] = {0, 256, 65536, 16777216, 4294967040u};
    Context context;
    support_open(&context);
    for (size_t k = 0; k < sizeof starts / sizeof *starts; k++) {
        char glsl[1024];
        snprintf(glsl, sizeof glsl,
                 "#include \"math/dialect.glsl\"\n#include \"sequence/sobol.glsl\"\n"
                 "vec4 evaluate(vec2 t) {\n"
                 "    Sequence s = sequence_start(uint(t.y), 5u, uint(t.x) + %uu, 1u);\n"
                 "    vec2 a = sequence_pair(s), b = sequence_pair(s); return vec4(a, b);\n}",
                 starts[k]);
        support_evaluate(&context, glsl, NULL, 256, 16, results);
        for (int pixel = 0; pixel < 16; pixel++) {
            for (int c = 0; c < 9; c++) {
                for (int pair = 0; pair < 2; pair++) {
                    int counts[256] = {0}, rows = 256 / columns[c];
                    for (int i = 0; i < 256; i++) {
                        const float *v = results + 4 * (256 * pixel + i) + 2 * pair;
                        counts[(int)(v[0] * (float)columns[c]) * rows + (int)(v[1] * (float)rows)]++;
                    }
                    for (int i = 0; i < 256; i++) assert_int_equal(counts[i], 1);
                }
            }
        }
    }
    context_close(&context);
}

/* Directions of a light method about a tilted normal; result: cosine to it, and a coordinate around it. */
static void draw_lobe(const Context *context, const char *method) {
    char glsl[1024];
    snprintf(
        glsl, sizeof glsl,
        "#include \"scene.glsl\"\n#include \"sequence/random.glsl\"\n#include \"sun/off.glsl\"\n#include "
        "\"emission/none.glsl\"\n#include \"mist/none.glsl\"\n#include "
        "\"light/%s.glsl\"\n"
        "void scene_intersect(Ray r, inout Hit h) {}\n"
        "Material scene_material(Hit h) { return material_new(0, vec3(1)); }\n"
        "Bounce material_sample(Material m, vec3 n, vec3 i, vec2 u, vec2 v) { return Bounce(n, vec3(1), "
        "0.0, false); }\n"
        "float material_pdf(Material m, vec3 n, vec3 i, vec3 o) { return 0.0; }\n"
        "vec3 material_value(Material m, vec3 n, vec3 i, vec3 o) { return vec3(0); }\n"
        "vec3 sky_radiance(vec3 d) { return vec3(1); }\n"
        "vec4 evaluate(vec2 t) {\n"
        "    vec3 n = normalize(vec3(1, -2, 0.5)), x = normalize(cross(n, vec3(0, 0, 1))), y = cross(n, x);\n"
        "    Sequence s = sequence_start(uint(t.x), uint(t.y), 3u, 0u);\n"
        "    vec2 a = sequence_pair(s), b = sequence_pair(s);\n"
        "    vec3 d = matte_direction(n, a, b);\n"
        "    return vec4(dot(d, n), 0.5 + atan(dot(d, y), dot(d, x)) / (2.0 * PI), length(d), 0);\n}",
        method);
    support_evaluate(context, glsl, NULL, SIDE, SIDE, results);
}

/* `cumulative` maps the cosine to a uniform number: the lobe is right if that and the angle around fill a
 * square. */
static void expect_lobe(const char *name, double (*cumulative)(double)) {
    int bins[32 * 32] = {0};
    for (int i = 0; i < TEXELS; i++) {
        const float *v = results + 4 * i;
        assert_true(v[0] >= -1e-6f && fabsf(v[2] - 1) < 1e-5f);
        double u = fmin(fmax(cumulative(v[0]), 0), 0.999999), w = fmin(v[1], 0.999999);
        bins[(int)(u * 32) * 32 + (int)(w * 32)]++;
    }
    double deviations = chi_square_deviations(bins, 32 * 32, TEXELS / 1024.0);
    if (fabs(deviations) > 4) fail_msg("%s: chi-square is %.1f deviations off", name, deviations);
}

static double cosine_cumulative(double c) {
    return c * c;
}

static double paper_cumulative(double c) {
    return c * c * c * c;
}

static void test_lobes(void **state) {
    (void)state;
    Context context;
    support_open(&context);
    draw_lobe(&context, "cosine");
    expect_lobe("cosine", cosine_cumulative);
    expect_mean("mean cosine of cos/pi", component_x, 2.0 / 3);
    draw_lobe(&context, "paper");
    expect_lobe("paper", paper_cumulative);
    expect_mean("mean cosine of 2 cos^3/pi", component_x, 0.8);
    context_close(&context);
}

/* Over the sphere a phase function integrates to 1, and Mie's mean cosine is the Cornette-Shanks value. */
static void test_phases(void **state) {
    (void)state;
    static const double asymmetry[] = {0, 0.3, 0.76, 0.95, 0.999, -0.3, -0.76, -0.999};
    Context context;
    support_open(&context);
    for (int k = -1; k < 8; k++) {
        char glsl[1024];
        double g = k < 0 ? 0 : asymmetry[k], sum = 0, cosine = 0, weight = 0;
        /* Angles crowd toward the forward and backward peaks: theta from log spaced 1 - |nu|, by
         * sin(theta/2)^2 = q. */
        snprintf(glsl, sizeof glsl,
                 "#include \"sky/phase.glsl\"\nvec4 evaluate(vec2 t) {\n"
                 "    float q = exp(mix(log(1e-13), log(0.5), (t.x + 512.0 * mod(t.y, 256.0) + 0.5) / "
                 "131072.0));\n"
                 "    float c = 2.0 * sqrt(q * (1.0 - q)), side = t.y < 256.0 ? 1.0 : -1.0;\n"
                 "    vec3 sun = vec3(0, 0, 1), view = vec3(c, 0, side * (1.0 - 2.0 * q));\n"
                 "    return vec4(%s, q, side, 0);\n}",
                 k < 0 ? "rayleigh_phase(view, sun)" : "mie_phase(G, view, sun)");
        char with_g[1200];
        snprintf(with_g, sizeof with_g, "const float G = %.4f;\n%s", g, glsl);
        support_evaluate(&context, with_g, NULL, SIDE, SIDE, results);
        for (int i = 0; i < TEXELS; i++) {
            const float *v = results + 4 * i;
            double q = v[1], solid_angle = 4 * acos(-1.0) * q * log(0.5 / 1e-13) / (TEXELS / 2);
            assert_true(isfinite(v[0]) && v[0] >= 0);
            weight += solid_angle;
            sum += solid_angle * (double)v[0];
            cosine += solid_angle * (double)v[0] * (1 - 2 * q) * (double)v[2];
        }
        double expected = k < 0 ? 0 : 3 * g * (4 + g * g) / (5 * (2 + g * g));
        if (fabs(weight / (4 * acos(-1.0)) - 1) > 1e-4 || fabs(sum - 1) > 3e-4 ||
            fabs(cosine - expected) > 5e-4) {
            fail_msg("phase %d, g %g: integral %.6f, mean cosine %.6f (expected %.6f)", k, g, sum, cosine,
                     expected);
        }
    }
    context_close(&context);
}

/* Bounces toward a sphere: directions uniform in its cone, with the density that cone_pdf says; their weights
 * in the mixture with the cosine integrate to what the cosine alone does. */
static void test_cones(void **state) {
    (void)state;
    static const double distances[] = {1.001, 1.5, 5, 1000};
    Context context;
    support_open(&context);
    for (int k = 0; k < 4; k++) {
        char glsl[2048];
        int bins[32 * 32] = {0};
        double d = distances[k], one_less_cos = 1 - sqrt(1 - 1 / (d * d)), inside = 0;
        if (d > 100) one_less_cos = 0.5 / (d * d);
        snprintf(glsl, sizeof glsl,
                 "#include \"math/cone.glsl\"\n#include \"math/hash.glsl\"\n"
                 "vec4 evaluate(vec2 t) {\n"
                 "    vec3 axis = normalize(vec3(0.3, -0.8, 0.5)), from = vec3(1, 2, 3);\n"
                 "    uvec3 h = hash_3(uvec3(uvec2(t), 7u));\n"
                 "    Cone cone = cone_toward(from, from + %.6f * axis, 1.0);\n"
                 "    vec3 d = cone_sample(cone, vec2(unit_float(h.x), unit_float(h.y)));\n"
                 "    vec3 x = normalize(cross(axis, vec3(0, 0, 1))), y = cross(axis, x), off = d - axis;\n"
                 "    return vec4(0.5 * dot(off, off) / cone.one_less_cos, 0.5 + atan(dot(d, y), dot(d, x)) "
                 "/ (2.0 * PI),\n"
                 "                cone_pdf(cone, d), cone_pdf(cone, normalize(axis + 1.1 * off / "
                 "max(length(off), 1e-9) *\n"
                 "                    sqrt(2.0 * cone.one_less_cos))));\n}",
                 d);
        support_evaluate(&context, glsl, NULL, SIDE, SIDE, results);
        for (int i = 0; i < TEXELS; i++) {
            const float *v = results + 4 * i;
            bins[(int)(fmin(fmax(v[0], 0), 0.999999) * 32) * 32 + (int)(fmin(v[1], 0.999999) * 32)]++;
            /* At the cone's very edge rounding decides. */
            if (v[0] < 0.999) assert_true(fabs((double)v[2] * 2 * acos(-1.0) * one_less_cos - 1) < 1e-3);
            inside += v[2] > 0;
        }
        assert_true(inside > 0.999 * TEXELS);
        double deviations = chi_square_deviations(bins, 32 * 32, TEXELS / 1024.0);
        if (fabs(deviations) > 4) fail_msg("cone at %g: chi-square is %.1f deviations off", d, deviations);
    }
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random), cmocka_unit_test(test_elementary_intervals),
        cmocka_unit_test(test_lobes),  cmocka_unit_test(test_phases),
        cmocka_unit_test(test_cones),
    };
    return cmocka_run_group_tests_name("sampling", tests, support_folder, support_clean);
}
