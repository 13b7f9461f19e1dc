/* Noise as an operator on distances: its slope is what a search over all places and all corner values finds,
 * no sample is steeper, no face of a cell is a seam, and surfaces and points are moved as far as they say.
 */
#include "random.h"
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SIDE = 512, ITEMS = SIDE * SIDE };

static float inputs[4 * ITEMS], results[4 * ITEMS];
static Context context;

/* The largest slope along `way`, of unit length, at the place `f` in a cell, whatever the values of its
 * corners are: those of which a larger value makes it steeper are 1, and the others 0. */
static double cell_slope(const double f[3], const double way[3]) {
    double blend[3], rise[3], sum = 0;
    for (int i = 0; i < 3; i++) {
        blend[i] = f[i] * f[i] * f[i] * (f[i] * (f[i] * 6 - 15) + 10);
        rise[i] = 30 * f[i] * f[i] * (1 - f[i]) * (1 - f[i]);
    }
    for (int corner = 0; corner < 8; corner++) {
        double slope = 0;
        for (int i = 0; i < 3; i++) {
            double part = way[i] * (corner >> i & 1 ? rise[i] : -rise[i]);
            for (int k = 0; k < 3; k++) {
                if (k != i) part *= corner >> k & 1 ? blend[k] : 1 - blend[k];
            }
            slope += part;
        }
        sum += fmax(slope, 0);
    }
    return sum;
}

/* The sum of the octaves' slopes. `at` is a place and a direction. */
static double octaves_slope(const double at[6], int octaves) {
    double size = sqrt(at[3] * at[3] + at[4] * at[4] + at[5] * at[5]), sum = 0;
    double way[3] = {at[3] / size, at[4] / size, at[5] / size};
    for (int i = 0; i < octaves; i++) {
        double f[3];
        for (int c = 0; c < 3; c++) f[c] = ldexp(at[c], i) - floor(ldexp(at[c], i));
        sum += cell_slope(f, way);
    }
    return sum;
}

/* Random steps, ever smaller, from random places. A third of these are near a third, where octaves are steep
 * together. */
static double steepest_octaves(int octaves) {
    double most = 0;
    for (int k = 0; k < 2000; k++) {
        double at[6];
        for (int c = 0; c < 6; c++) at[c] = c < 3 ? random_unit() : 2 * random_unit() - 1;
        for (int c = 0; c < 3 && k % 3 == 0; c++) at[c] = (1 + 0.02 * at[c]) / 3;
        double best = octaves_slope(at, octaves);
        for (double step = 0.1; step > 1e-7; step *= 0.94) {
            double next[6];
            for (int c = 0; c < 6; c++) next[c] = at[c] + step * (2 * random_unit() - 1);
            double slope = octaves_slope(next, octaves);
            if (slope > best) best = slope, memcpy(at, next, sizeof at);
        }
        most = fmax(most, best);
    }
    return most;
}

static void evaluate(const char *body) {
    char glsl[4096];
    snprintf(
        glsl, sizeof glsl,
        "#include \"distance/noise.glsl\"\n#include \"distance/sphere.glsl\"\nuniform sampler2D inputs;\n"
        "vec3 slopes(vec3 p, vec3 h) { return (noise_vector(p + h) - noise_vector(p - h)) / (2.0 * "
        "length(h)); }\n"
        "vec4 evaluate(vec2 t) {\n    vec4 a = texelFetch(inputs, ivec2(t), 0);\n"
        "    vec3 p = vec3(a), x = vec3(1, 0, 0), y = vec3(0, 1, 0), z = vec3(0, 0, 1);\n"
        "    vec4 c = vec4(0.0);\n    %s\n    return c;\n}\n",
        body);
    support_evaluate(&context, glsl, inputs, SIDE, SIDE, results);
}

/* Points within `reach` of the origin, and a random number beside them. */
static void start(void **state, double reach) {
    (void)state;
    support_open(&context);
    random_state = 7;
    for (int i = 0; i < ITEMS; i++) {
        for (int c = 0; c < 3; c++) inputs[4 * i + c] = (float)(reach * (2 * random_unit() - 1));
        inputs[4 * i + 3] = (float)random_unit();
    }
}

static double largest(int result) {
    double most = 0;
    for (int i = 0; i < ITEMS; i++) most = fmax(most, (double)fabsf(results[4 * i + result]));
    return most;
}

static void test_slope_searched(void **state) {
    start(state, 1);
    for (int octaves = 1; octaves <= 8; octaves++) {
        char body[128];
        snprintf(body, sizeof body, "c.x = noise_octaves_slope(%d);", octaves);
        evaluate(body);
        double said = (double)results[0] * (2 - ldexp(2, -octaves)), found = steepest_octaves(octaves);
        print_message("%d octaves: the slopes sum to %.4f of %.4f\n", octaves, found, said);
        assert_true(found < said * 1.00001 && found > 0.99 * said);
    }
    context_close(&context);
}

/* Half of the points are in the middle of a cell along one axis, where noise() is steepest. */
static void test_slope_sampled(void **state) {
    start(state, 40);
    for (int i = 0; i < ITEMS; i += 2) inputs[4 * i] = floorf(inputs[4 * i]) + 0.5f;
    for (int octaves = 1; octaves <= 5; octaves++) {
        char body[512];
        snprintf(
            body, sizeof body,
            "float h = 0.004 * exp2(1.0 - float(%d));\n"
            "    for (int i = 0; i < 3; i++) {\n        vec3 s = vec3(i == 0 ? h : 0.0, i == 1 ? h : 0.0, i "
            "== 2 ? h : 0.0);\n"
            "        float rise = (noise_octaves(p + s, %d) - noise_octaves(p - s, %d)) / (2.0 * h);\n"
            "        c.x += rise * rise;\n    }\n"
            "    c = vec4(sqrt(c.x), noise_octaves_slope(%d), 0.0, 0.0);\n",
            octaves, octaves, octaves, octaves);
        evaluate(body);
        double found = largest(0), said = (double)results[1];
        print_message("%d octaves: slope to %.3f of %.3f\n", octaves, found, said);
        assert_true(found < 1.002 * said && found > (octaves == 1 ? 0.8 : 0.5) * said);
    }
    context_close(&context);
}

/* Across the faces of the cells the noise has one slope: with linear shares it would change by up to 2. */
static void test_seams(void **state) {
    start(state, 40);
    for (int i = 0; i < ITEMS; i++) inputs[4 * i + i % 3] = roundf(inputs[4 * i + i % 3]);
    evaluate("vec3 h = (p.x == floor(p.x) ? x : p.y == floor(p.y) ? y : z) / 64.0;\n"
             "    vec3 here = noise_vector(p);\n"
             "    vec3 bend = 64.0 * (noise_vector(p + h) + noise_vector(p - h) - 2.0 * here);\n"
             "    c = vec4(length(bend), here.x - noise(p), here.y, here.z);\n");
    print_message("the slope changes by %.4f\n", largest(0));
    /* 10 / 64^2 is how far the quintic has risen after a 64th. */
    assert_true(largest(0) < sqrt(3) * 2 * 10 / (64 * 64) * 1.1 && largest(1) < 1e-6);
    context_close(&context);
}

/* The three noises have the mean and the variance of uniform numbers at the corners, and do not go together.
 */
static void test_vector(void **state) {
    start(state, 1000);
    for (int i = 0; i < 4 * ITEMS; i++) inputs[i] = floorf(inputs[i]);
    evaluate("c = vec4(noise_vector(p), 0.0);");
    double mean[3] = {0}, product[3][3] = {{0}};
    for (int i = 0; i < ITEMS; i++) {
        for (int a = 0; a < 3; a++) {
            mean[a] += (double)results[4 * i + a] / ITEMS;
            for (int b = 0; b < 3; b++)
                product[a][b] +=
                    ((double)results[4 * i + a] - 0.5) * ((double)results[4 * i + b] - 0.5) / ITEMS;
        }
    }
    /* Four standard errors of uniform numbers. */
    for (int a = 0; a < 3; a++) {
        assert_true(fabs(mean[a] - 0.5) < 4 / sqrt(12.0 * ITEMS));
        for (int b = 0; b < 3; b++)
            assert_true(fabs(product[a][b] - (a == b) / 12.0) < 4 / sqrt((a == b ? 180.0 : 144.0) * ITEMS));
    }
    context_close(&context);
}

/* A ball raised by noise: on the right side, never steeper than a metre a metre, and nowhere a shorter step
 * than op_displace() allows. */
static void test_raised(void **state) {
    static const struct {
        const char *name, *field, *height, *slope;
    } cases[] = {
        {"noise", "op_noise(BALL, p, 0.2, 0.3)", "0.2 * noise(p / 0.3)", "0.2 / 0.3 * NOISE_SLOPE"},
        {"octaves", "op_noise_octaves(BALL, p, 0.2, 0.3, 4)", "0.2 * noise_octaves(p / 0.3, 4)",
         "0.2 / 0.3 * noise_octaves_slope(4)"},
    };
    start(state, 1.5);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char body[1024];
        snprintf(
            body, sizeof body,
            "\n#define BALL (length(p) - 0.8)\n#define FIELD %s\n"
            "    float here = FIELD, outline = BALL - %s, plain = op_displace(outline, 0.0, %s);\n"
            "    p = p + 0.01 * (fract(a.w * vec3(1.0, 37.0, 1369.0)) - 0.5);\n"
            "    c = vec4(here, outline, (FIELD - here) / length(p - vec3(a)), abs(here) - abs(plain));\n",
            cases[k].field, cases[k].height, cases[k].slope);
        evaluate(body);
        int inside = 0, farther = 0;
        for (int i = 0; i < ITEMS; i++) {
            const float *c = results + 4 * i;
            inside += c[1]<0, farther += c[3]> 0.1f;
            assert_true((c[0] < 0) == (c[1] < 0) || fabsf(c[1]) < 1e-6f);
            assert_true(c[3] > -1e-6f);
        }
        print_message("%s: %d inside, steepness to %.4f, %d with farther steps\n", cases[k].name, inside,
                      largest(2), farther);
        assert_true(inside > ITEMS / 16 && largest(2) < 1.0005 && farther > ITEMS / 4);
    }
    context_close(&context);
}

/* Points move by the amplitude at most along each axis, and nearly so somewhere. The longest stretch is the
 * root of the largest eigenvalue. Half of the points are in the middle of a cell along one axis. */
static void test_warp(void **state) {
    start(state, 40);
    for (int i = 0; i < ITEMS; i += 2) inputs[4 * i] = floorf(inputs[4 * i]) + 0.5f;
    for (int i = 0; i < 4 * ITEMS; i++) inputs[i] *= 0.5f;
    evaluate("float h = 0.002;\n"
             "    mat3 change = mat3(1.0) + 0.2 * mat3(slopes(2.0 * p, h * x), slopes(2.0 * p, h * y), "
             "slopes(2.0 * "
             "p, h * z)) / 0.5;\n"
             "    vec3 v = vec3(0.6, 0.5, 0.4);\n"
             "    for (int i = 0; i < 40; i++) v = normalize(transpose(change) * (change * v));\n"
             "    vec3 q = op_warp(p, 0.1, 0.5), off = abs(q - p);\n"
             "    vec3 along = (op_warp(p + h * v, 0.1, 0.5) - op_warp(p - h * v, 0.1, 0.5)) / (2.0 * h);\n"
             "    c = vec4(length(change * v), op_warp_steepness(0.1, 0.5), max(max(off.x, off.y), off.z), "
             "length(along) - length(change * v));\n");
    double stretch = largest(0), said = (double)results[1], moved = largest(2);
    print_message("stretched to %.4f of %.4f, moved by %.4f of 0.1, stretches differ by %.1e\n", stretch,
                  said, moved, largest(3));
    assert_true(stretch < 1.0005 * said && stretch > 0.8 * said);
    assert_true(moved < 0.1 + 4e-6 && moved > 0.09 && largest(3) < 5e-3);
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_slope_searched), cmocka_unit_test(test_slope_sampled),
        cmocka_unit_test(test_seams),          cmocka_unit_test(test_vector),
        cmocka_unit_test(test_raised),         cmocka_unit_test(test_warp)};
    return cmocka_run_group_tests_name("distance_noise", tests, support_folder, support_clean);
}
