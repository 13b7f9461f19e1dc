/* Distance fields on the GPU: never more than the distance, exact where they say so; and marching them finds
 * what the exact shapes find.
 */
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ITEMS = 64 * 64 };

/* Eight numbers an item, in pairs of texels: a point and s; a direction and another number. */
static float inputs[8 * ITEMS], results[8 * ITEMS];
static unsigned random_state;
static Context context;

static double random_unit(void) {
    random_state = random_state * 1664525u + 1013904223u;
    return (random_state >> 8) / 16777216.0;
}

static void start(void **state) {
    (void)state;
    random_state = 3;
    support_open(&context);
}

static double length3(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* `declarations` go before main; `body` takes p, s, direction, other and sets c and d. */
static void evaluate(const char *declarations, const char *body) {
    static char glsl[8192];
    snprintf(glsl, sizeof glsl,
             "uniform sampler2D inputs;\nfloat s;\n%s\n"
             "vec4 evaluate(vec2 t) {\n"
             "    ivec2 at = ivec2(int(t.x) / 2 * 2, int(t.y));\n"
             "    vec4 a = texelFetch(inputs, at, 0), b = texelFetch(inputs, at + ivec2(1, 0), 0);\n"
             "    vec3 p = a.xyz, direction = b.xyz;\n    float other = b.w;\n    s = a.w;\n"
             "    vec4 c = vec4(0.0), d = vec4(0.0);\n    %s\n"
             "    return int(t.x) %% 2 == 0 ? c : d;\n}",
             declarations, body);
    support_evaluate(&context, glsl, inputs, 128, 64, results);
}

/* Points about the origin at three scales, `reach` scales around, with directions toward the middle for half
 * of them. */
static void make_inputs(const double *reaches, int reach_count, int scale_count) {
    static const double scales[] = {1, 1e-3, 1e4};
    for (int i = 0; i < ITEMS; i++) {
        float *point = inputs + 8 * i, *direction = point + 4;
        double scale = scales[i % scale_count], reach = scale * reaches[i / scale_count % reach_count], v[3];
        for (int c = 0; c < 3; c++) {
            point[c] = (float)(reach * (2 * random_unit() - 1));
            v[c] = (i % 4 ? 1.2 * scale : 2 * reach) * (2 * random_unit() - 1) - (double)point[c];
        }
        for (int c = 0; c < 3; c++) direction[c] = (float)(v[c] / length3(v));
        point[3] = (float)scale;
        direction[3] = (float)random_unit();
    }
}

#define CENTRE "s * vec3(0.125, -0.25, 0.5)"
#define ENDS(reach)                                                                                          \
    "s * (vec3(0.125, -0.25, 0.5) - " reach " * vec3(0.48, 0.6, 0.64)), "                                    \
    "s * (vec3(0.125, -0.25, 0.5) + " reach " * vec3(0.48, 0.6, 0.64))"

/* distance_NAME(p, WORDS) and hit_NAME(ray, WORDS, object, hit) */
static const struct Shape {
    const char *name, *words;
    double edged; /* the share of points that an edge may be nearest to, at most */
} shapes[] = {
    {"sphere", CENTRE ", s * 0.8", 0.01},
    {"plane", "vec3(0.48, 0.6, 0.64), s * 0.3", 0.01},
    {"box", CENTRE ", s * vec3(0.7, 0.4, 1.0)", 0.1},
    {"rounded_box", CENTRE ", s * vec3(0.7, 0.4, 1.0), s * 0.25", 0.01},
    {"disk", CENTRE ", vec3(0.48, 0.6, 0.64), s * 0.9", 0.5},
    {"cylinder", ENDS("0.8") ", s * 0.4", 0.1},
    {"capsule", ENDS("0.6") ", s * 0.4", 0.01},
    {"cone", ENDS("0.8") ", s * 0.6", 0.3},
    {"torus", CENTRE ", vec3(0.48, 0.6, 0.64), s * 0.8, s * 0.3", 0.01},
    {"torus", CENTRE ", vec3(0.48, 0.6, 0.64), s * 0.8, s * 0.05", 0.01},
    {"ellipsoid", CENTRE ", s * vec3(1.0, 0.5, 0.15)", 0.02},
    {"ellipsoid", CENTRE ", s * vec3(0.15, 0.9, 0.9)", 0.02},
};
enum { SHAPES = sizeof shapes / sizeof *shapes };

/* The ball of the distance about a point is empty: no ray meets the surface in it. It is no smaller than it
 * could be: the ray along the gradient meets the surface just there. */
static void test_exact(void **state) {
    static const double reaches[] = {1.2, 4};
    start(state);
    for (int k = 0; k < SHAPES; k++) {
        char declarations[2048];
        const char *name = shapes[k].name, *words = shapes[k].words;
        int inside = 0, unsettled = 0;
        double worst = 0, steepest = 0;
        make_inputs(reaches, 2, 3);
        snprintf(declarations, sizeof declarations,
                 "#include \"shape/%s.glsl\"\n#include \"distance/%s.glsl\"\n"
                 "float field(vec3 p) { return distance_%s(p, %s); }\n"
                 "float meet(Ray ray) { Hit hit = hit_none(); hit_%s(ray, %s, 1, hit); return hit.t; }\n",
                 name, name, name, words, name, words);
        evaluate(declarations,
                 "float h = 1.0e-3 * s;\n"
                 "    vec3 g = vec3(field(p + vec3(h, 0, 0)) - field(p - vec3(h, 0, 0)),\n"
                 "                  field(p + vec3(0, h, 0)) - field(p - vec3(0, h, 0)),\n"
                 "                  field(p + vec3(0, 0, h)) - field(p - vec3(0, 0, h))) / (2.0 * h);\n"
                 "    float value = field(p);\n"
                 "    c = vec4(value / s, meet(Ray(p, direction)) / s, length(g), 0.0);\n"
                 "    d.x = meet(Ray(p, value < 0.0 ? normalize(g) : -normalize(g))) / s;\n");
        for (int i = 0; i < ITEMS; i++) {
            const float *c = results + 8 * i;
            double value = fabs((double)c[0]), steepness = (double)c[2], error = fabs((double)c[4] - value);
            inside += c[0] < 0;
            assert_true(isfinite(value));
            if ((double)c[1] < value - 4e-6)
                fail_msg("%s: %g over the distance %g", name, value, (double)c[1]);
            steepest = fmax(steepest, steepness);
            /* Between two nearest points the gradient is short and points at neither; a ray at an edge may
             * slip past. */
            if (steepness < 0.999 || error > 2e-3)
                unsettled++;
            else if (value > 1e-3)
                worst = fmax(worst, error);
        }
        print_message("%s: %d of %d inside, largest error %.1e, steepness to %.5f, %d unsettled\n", name,
                      inside, ITEMS, worst, steepest, unsettled);
        assert_true(steepest < 1.003 && unsettled <= shapes[k].edged * ITEMS);
        assert_true(strcmp(name, "disk") == 0 ? inside == 0 : inside > 2);
    }
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_exact),
    };
    return cmocka_run_group_tests_name("distance", tests, support_folder, support_clean);
}
