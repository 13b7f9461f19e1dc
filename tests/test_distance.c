/* Distance fields on the GPU: never more than the distance, exact where they say so; and marching them finds
 * what the exact shapes find.
 */
#include "random.h"
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ITEMS = 64 * 64 };

/* Eight numbers an item, in pairs of texels: a point and s; a direction and another number. */
static float inputs[8 * ITEMS], results[8 * ITEMS];
static Context context;

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
    static char glsl[16384];
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

/* c = march's t, the exact t, what was broken and cut; d = difference of the normals, cosine of incidence,
 * evaluations. The shape is `words` of the shapes' `name`; its field is multiplied by `factor`. */
static void march_beside_exact(const char *name, const char *words, double factor, const char *bound) {
    char declarations[2048], body[2048];
    snprintf(declarations, sizeof declarations,
             "#include \"shape/%s.glsl\"\n#include \"distance/%s.glsl\"\n#include \"shape/march.glsl\"\n"
             "int evaluations = 0;\n"
             "float scene_distance(vec3 p) { evaluations++; return float(%f) * distance_%s(p, %s); }\n",
             name, name, factor, name, words);
    snprintf(body, sizeof body,
             "Ray ray = Ray(p, direction);\n"
             "    Hit exact = hit_none(), marched = hit_none();\n"
             "    hit_%s(ray, %s, 1, exact);\n    march(ray, %s 1, marched);\n"
             "    c = vec4(marched.t / s, exact.t / s, search_broken, search_cut);\n"
             "    d = vec4(length(marched.normal - exact.normal), dot(exact.normal, ray.direction), "
             "evaluations, 0.0);",
             name, words, bound);
    evaluate(declarations, body);
}

typedef struct Marched {
    int hits, differ, wrong_normals, broken, cut, most;
    double worst, evaluations;
} Marched;

static Marched compare_march(const char *name, double reach_bias) {
    Marched m = {0};
    for (int i = 0; i < ITEMS; i++) {
        const float *c = results + 8 * i, *d = c + 4;
        double scale = (double)inputs[8 * i + 3], size = 0;
        m.broken += c[2] > 0, m.cut += c[3] > 0;
        m.evaluations += (double)d[2] / ITEMS;
        if (d[2] > (float)m.most) m.most = (int)d[2];
        bool hit = c[0] < 1e20f, exact = (double)c[1] * scale < 9e5;
        if (hit != exact) m.differ++;
        if (!hit || !exact) continue;
        for (int k = 0; k < 3; k++) size = fmax(size, fabs((double)inputs[8 * i + k]) / scale);
        double off = fabs((double)c[0] - (double)c[1]) * fmax(fabs((double)d[1]), 1e-3);
        double error = off / (reach_bias + size + (double)c[1]);
        m.hits++;
        /* Past an edge, a rounding decides which face is seen. */
        if (d[0] > 3e-3f)
            m.wrong_normals++;
        else if (error > 3e-6)
            m.differ++;
        else
            m.worst = fmax(m.worst, error);
    }
    print_message(
        "%s: %d hits, largest error %.1e, %d differ, %d normals; %.1f evaluations, at most %d; %d broken, "
        "%d cut\n",
        name, m.hits, m.worst, m.differ, m.wrong_normals, m.evaluations, m.most, m.broken, m.cut);
    return m;
}

/* The march finds what the exact shapes find, at millimetres, metres and 10 km, from outside and inside. */
static void test_march(void **state) {
    static const double reaches[] = {1.2, 4, 30};
    start(state);
    for (int k = 0; k < SHAPES; k++) {
        if (strcmp(shapes[k].name, "disk") == 0) continue;
        make_inputs(reaches, 3, 3);
        march_beside_exact(shapes[k].name, shapes[k].words, 1, "");
        Marched m = compare_march(shapes[k].name, 1);
        assert_true(m.hits > ITEMS / 16 && m.differ <= ITEMS / 500 && m.wrong_normals <= m.hits / 100);
        assert_true(m.worst < 3e-6 && m.broken == 0 &&
                    m.cut < ITEMS / (strcmp(shapes[k].name, "plane") == 0 ? 20 : 1000));
    }
    context_close(&context);
}

static void test_march_in_bound(void **state) {
    static const double reaches[] = {1.2, 4, 30};
    char bound[128];
    start(state);
    make_inputs(reaches, 3, 3);
    march_beside_exact("box", shapes[2].words, 1, "");
    Marched all = compare_march("box", 1);
    march_beside_exact("box", shapes[2].words, 1, CENTRE ", s * 1.29,");
    Marched ball = compare_march("box in a ball", 1);
    assert_true(ball.hits == all.hits && ball.differ <= ITEMS / 500 && ball.broken == 0);
    assert_true(ball.evaluations < 0.8 * all.evaluations);
    /* All of its sides lie in the box that bounds it. */
    snprintf(bound, sizeof bound, "%s,", shapes[2].words);
    march_beside_exact("box", shapes[2].words, 1, bound);
    Marched box = compare_march("box in its own bounds", 1);
    assert_true(box.hits == all.hits && box.differ <= ITEMS / 500 && box.broken == 0);
    assert_true(box.wrong_normals <= box.hits / 100 && box.evaluations < 0.8 * ball.evaluations);
    context_close(&context);
}

/* A field that is no distance leaves no holes, and is told. */
static void test_steep(void **state) {
    static const double reaches[] = {1.2, 4};
    start(state);
    for (int k = 0; k < SHAPES; k++) {
        if (strcmp(shapes[k].name, "disk") == 0) continue;
        make_inputs(reaches, 2, 3);
        march_beside_exact(shapes[k].name, shapes[k].words, 3, "");
        Marched m = compare_march(shapes[k].name, 1);
        /* The thin ring is leapt over before it is known. */
        assert_true(m.broken > ITEMS * 4 / 5 &&
                    m.differ <= m.hits / (strcmp(shapes[k].name, "torus") == 0 ? 4 : 100));
    }
    context_close(&context);
}

/* Rays that leave a marched surface: into all directions from where camera rays hit, into the solid too, they
 * meet what the exact shape meets, and never the place that they leave. */
static void test_leave(void **state) {
    static const double reaches[] = {1.2, 4, 30};
    static const int kept[] = {0, 1, 2, 3, 6, 8};
    start(state);
    for (size_t k = 0; k < sizeof kept / sizeof *kept; k++) {
        char declarations[2048], body[2048];
        const struct Shape *shape = &shapes[kept[k]];
        int left = 0, caught = 0, differ = 0, broken = 0;
        make_inputs(reaches, 3, 3);
        snprintf(declarations, sizeof declarations,
                 "#include \"shape/%s.glsl\"\n#include \"distance/%s.glsl\"\n#include \"shape/march.glsl\"\n"
                 "float scene_distance(vec3 p) { return distance_%s(p, %s); }\n",
                 shape->name, shape->name, shape->name, shape->words);
        snprintf(body, sizeof body,
                 "Ray ray = Ray(p, direction);\n    Hit hit = hit_none(), exact = hit_none(), marched = "
                 "hit_none();\n"
                 "    march(ray, 1, hit);\n    if (hit.t >= INFINITY) return vec4(0.0);\n"
                 "    hit.position = p + hit.t * direction;\n"
                 "    vec3 around = normalize(fract(vec3(other, 7.0 * other, 49.0 * other)) - 0.5);\n"
                 "    hit.normal = dot(hit.normal, around) < 0.0 ? -hit.normal : hit.normal;\n"
                 "    Ray onward = ray_from(hit, around);\n"
                 "    hit_%s(onward, %s, 1, exact);\n    march(onward, 1, marched);\n"
                 "    float size = s + march_size(onward.origin) + hit.t;\n"
                 "    c = vec4(marched.t / size, exact.t / size, dot(around, hit.normal), 1.0);\n"
                 "    d = vec4(search_broken, search_cut, 0.0, 0.0);\n",
                 shape->name, shape->words);
        evaluate(declarations, body);
        for (int i = 0; i < ITEMS; i++) {
            const float *c = results + 8 * i;
            left += c[3] > 0;
            broken += c[4] > 0;
            if (c[3] == 0 || c[2] < 0.02f || c[1] * inputs[8 * i + 3] > 1e4f) continue;
            if (c[0] < 1e-4f && c[1] > 1e-3f) caught++;
            if ((c[0] < 1e20f) != (c[1] < 1e20f) || (c[0] < 1e20f && fabsf(c[0] - c[1]) > 1e-3f)) differ++;
        }
        print_message("%s: %d left, %d caught, %d differ, %d broken\n", shape->name, left, caught, differ,
                      broken);
        assert_true(left > ITEMS / 16 && caught == 0 && differ <= left / 200 && broken == 0);
    }
    context_close(&context);
}

/* Over a plane to its horizon: every ray below it hits, at the right place, and those that took all their
 * steps are counted. */
static void test_grazing(void **state) {
    start(state);
    int cut = 0;
    for (int i = 0; i < ITEMS; i++) {
        double slope = 0.3 * pow(10, -5.0 * i / ITEMS), scale = i % 2 ? 1 : 1e-3;
        const double point[3] = {0.3 * scale, 1.7 * scale, -2 * scale};
        for (int c = 0; c < 3; c++) inputs[8 * i + c] = (float)point[c];
        inputs[8 * i + 3] = (float)scale;
        inputs[8 * i + 4] = (float)(0.6 * sqrt(1 - slope * slope)), inputs[8 * i + 5] = (float)-slope;
        inputs[8 * i + 6] = (float)(0.8 * sqrt(1 - slope * slope));
    }
    evaluate("#include \"distance/plane.glsl\"\n#include \"shape/march.glsl\"\n"
             "float scene_distance(vec3 p) { return distance_plane(p, vec3(0.0, 1.0, 0.0), 0.0); }\n",
             "Hit hit = hit_none();\n    march(Ray(p, direction), 1, hit);\n"
             "    c = vec4(hit.t / s, hit.normal);\n    d = vec4(search_broken, search_cut, 0.0, 0.0);\n");
    for (int i = 0; i < ITEMS; i++) {
        const float *c = results + 8 * i;
        double t = (double)c[0], height = 1.7 + t * (double)inputs[8 * i + 5];
        /* Nearer by the tangent than the march itself ends, where that is not past what the tangent is
         * trusted for. */
        if (!(fabs(height) < (inputs[8 * i + 5] < -0.02f ? 2.5e-7 : 1e-6) * t))
            fail_msg("slope %g: %g over the plane at %g", (double)inputs[8 * i + 5], height, t);
        assert_true(c[2] > 0.99999f && c[4] == 0);
        cut += c[5] > 0;
        if (inputs[8 * i + 5] < -0.05f) assert_true(c[5] == 0);
    }
    print_message("%d of %d cut\n", cut, ITEMS);
    assert_true(cut > 0 && cut < ITEMS / 5);
    context_close(&context);
}

/* Boards a millimetre thick, seen along: rays that reach one hit it, however long they ran beside others. */
static void test_fence(void **state) {
    start(state);
    int hits = 0, differ = 0, cut = 0;
    for (int i = 0; i < ITEMS; i++) {
        float *point = inputs + 8 * i, *direction = point + 4;
        double target[3] = {6 * random_unit() - 3, 1.2 * random_unit(), 10 * random_unit()}, v[3];
        point[0] = (float)(8 * random_unit() - 4), point[1] = (float)random_unit(), point[2] = -3,
        point[3] = 1;
        for (int c = 0; c < 3; c++) v[c] = target[c] - (double)point[c];
        for (int c = 0; c < 3; c++) direction[c] = (float)(v[c] / length3(v));
    }
    evaluate(
        "#include \"distance/box.glsl\"\n#include \"distance/repeat.glsl\"\n#include \"shape/box.glsl\"\n"
        "#include \"shape/march.glsl\"\n"
        "const vec3 SPACING = vec3(0.5, 0.0, 0.5), COUNT = vec3(6.0, 0.0, 7.0), SIZE = vec3(0.0005, 1.0, "
        "0.1);\n"
        "float scene_distance(vec3 p) {\n    float d = INFINITY;\n    for (int i = 0; i < 4; i++)\n"
        "        d = min(d, distance_box(repeat_cell(p, SPACING, COUNT, i), vec3(0.0), SIZE));\n    return "
        "d;\n}\n",
        "Ray ray = Ray(p, direction);\n    Hit hit = hit_none(), exact = hit_none();\n    march(ray, 1, "
        "hit);\n"
        "    for (int x = 0; x < 6; x++) for (int z = 0; z < 7; z++)\n"
        "        hit_box(ray, vec3(0.5 * float(x) - 1.25, 0.0, 0.5 * float(z) - 1.5), SIZE, 1, exact);\n"
        "    c = vec4(hit.t, exact.t, length(hit.normal - exact.normal), 0.0);\n"
        "    d = vec4(search_broken, search_cut, 0.0, 0.0);\n");
    for (int i = 0; i < ITEMS; i++) {
        const float *c = results + 8 * i;
        hits += c[1] < 1e20f;
        if ((c[0] < 1e20f) != (c[1] < 1e20f) || (c[0] < 1e20f && fabsf(c[0] - c[1]) > 1e-4f)) differ++;
        cut += c[5] > 0;
        assert_true(c[4] == 0);
    }
    print_message("%d hits, %d differ, %d cut\n", hits, differ, cut);
    assert_true(hits > ITEMS / 8 && differ <= hits / 500 && cut <= ITEMS / 100);
    context_close(&context);
}

/* Operators beside the same solid said otherwise; and none changes faster than a metre a metre, which with
 * the right surface makes it never more than the distance. `other` of the inputs is random. */
static void test_operators(void **state) {
    static const double reaches[] = {1.2, 4};
    static const struct {
        const char *name, *got, *expected; /* as much, or where `mode` is -1 less */
        int mode;
    } cases[] = {
        {"translation", "distance_box(op_translate(p, s * A), vec3(0), s * B)",
         "distance_box(p, s * A, s * B)", 0},
        {"rotation", "distance_capsule(op_rotate(p, N, 0.7), vec3(0), s * A, s * 0.2)",
         "distance_capsule(p, vec3(0), s * turned(A), s * 0.2)", 0},
        {"scale", "2.5 * distance_box(op_scale(p, 2.5), s * A, s * B)",
         "distance_box(p, 2.5 * s * A, 2.5 * s * B)", 0},
        {"elongation", "distance_sphere(op_elongate(p, s * vec3(0, 0.5, 0)), vec3(0), s * 0.3)",
         "distance_capsule(p, s * vec3(0, -0.5, 0), s * vec3(0, 0.5, 0), s * 0.3)", 0},
        {"rounding", "op_round(distance_box(p, s * A, s * B), s * 0.1)",
         "distance_rounded_box(p, s * A, s * (B + 0.1), s * 0.1)", 0},
        {"shell", "op_shell(distance_sphere(p, s * A, s), s * 0.2)",
         "max(distance_sphere(p, s * A, s * 1.1), -distance_sphere(p, s * A, s * 0.9))", 0},
        {"union", "op_union(BOX, BALL)", "box_or_ball(p)", 0},
        {"intersection", "op_intersection(BOX, BALL)", "-op_union(op_inverse(BOX), op_inverse(BALL))", 0},
        {"subtraction", "op_subtraction(BOX, BALL)", "op_intersection(BOX, op_inverse(BALL))", 0},
        {"smooth union", "op_smooth_union(BOX, BALL, s * 0.3)", "op_union(BOX, BALL)", -1},
        {"smooth intersection", "-op_smooth_intersection(BOX, BALL, s * 0.3)", "-op_intersection(BOX, BALL)",
         -1},
        {"smooth subtraction", "-op_smooth_subtraction(BOX, BALL, s * 0.3)", "-op_subtraction(BOX, BALL)",
         -1},
        {"sharp smooth union", "op_smooth_union(BOX, BALL, 0.0)", "op_union(BOX, BALL)", 0},
        {"row", "row(p)", "copies(p, ivec3(5, 1, 1))", 0},
        {"lattice", "lattice(p)", "copies(p, ivec3(4, 3, 2))", 0},
        {"endless row", "endless(p)", "copies(p, ivec3(33, 1, 1))", 0},
    };
    static const char *declarations =
        "#include \"distance/boolean.glsl\"\n#include \"distance/box.glsl\"\n#include "
        "\"distance/capsule.glsl\"\n"
        "#include \"distance/elongate.glsl\"\n#include \"distance/move.glsl\"\n#include "
        "\"distance/offset.glsl\"\n"
        "#include \"distance/repeat.glsl\"\n#include \"distance/rounded_box.glsl\"\n#include "
        "\"distance/smooth.glsl\"\n"
        "#include \"distance/sphere.glsl\"\n"
        "const vec3 A = vec3(0.3, -0.2, 0.5), B = vec3(0.4, 0.7, 0.2), N = vec3(0.48, 0.6, 0.64);\n"
        "const vec3 GAP = vec3(0.7, 0.9, 1.1);\n"
        "#define BOX distance_box(p, s * A, s * B)\n#define BALL distance_sphere(p, vec3(0), s * 0.5)\n"
        "float box_or_ball(vec3 p) { float a = BOX, b = BALL; return a < b ? a : b; }\n"
        "vec3 turned(vec3 v) { // N is the third of a right-handed frame\n"
        "    vec3 x = normalize(v - dot(v, N) * N), y = cross(N, x);\n"
        "    return dot(v, N) * N + length(v - dot(v, N) * N) * (cos(0.7) * x + sin(0.7) * y); }\n"
        "/* off the middle of its cell */\n"
        "float one(vec3 p) { return distance_box(p, s * vec3(0.15, -0.1, 0.2), s * vec3(0.15, 0.25, 0.3)); "
        "}\n"
        "float copies(vec3 p, ivec3 n) {\n    float d = 1e30;\n"
        "    for (int x = 0; x < n.x; x++) for (int y = 0; y < n.y; y++) for (int z = 0; z < n.z; z++)\n"
        "        d = min(d, one(p - s * GAP * (vec3(x, y, z) - 0.5 * vec3(n - 1))));\n    return d;\n}\n"
        "float row(vec3 p) { float d = 1e30;\n    for (int i = 0; i < 2; i++)\n"
        "        d = min(d, one(repeat_cell(p, s * vec3(GAP.x, 0, 0), vec3(5, 0, 0), i)));\n    return "
        "d;\n}\n"
        "float lattice(vec3 p) { float d = 1e30;\n    for (int i = 0; i < 8; i++)\n"
        "        d = min(d, one(repeat_cell(p, s * GAP, vec3(4, 3, 2), i)));\n    return d;\n}\n"
        "float endless(vec3 p) { float d = 1e30;\n    for (int i = 0; i < 2; i++)\n"
        "        d = min(d, one(repeat_cell(p, s * vec3(GAP.x, 0, 0), vec3(0), i)));\n    return d;\n}\n";
    start(state);
    make_inputs(reaches, 2, 3);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char all[8192], body[1024];
        double worst = 0, steepest = 0, band = 0;
        snprintf(all, sizeof all,
                 "%s\nfloat got(vec3 p) { return %s; }\nfloat expected(vec3 p) { return %s; }\n",
                 declarations, cases[k].got, cases[k].expected);
        snprintf(body, sizeof body,
                 "vec3 q = p + 0.3 * s * other * direction;\n"
                 "    c = vec4(got(p) / s, expected(p) / s, (got(q) - got(p)) / length(q - p), 0.0);\n");
        evaluate(all, body);
        for (int i = 0; i < ITEMS; i++) {
            const float *c = results + 8 * i;
            double error = (double)c[0] - (double)c[1];
            if (inputs[8 * i + 7] > 0.01f) steepest = fmax(steepest, fabs((double)c[2]));
            if (cases[k].mode == 0)
                worst = fmax(worst, fabs(error));
            else
                worst = fmax(worst, error), band = fmax(band, -error);
        }
        print_message("%s: largest error %.1e, steepness to %.5f, band %.4f\n", cases[k].name, worst,
                      steepest, band);
        assert_true(worst < 3e-6 && steepest < 1.0005);
        /* A quarter of k, where both are as far. */
        if (cases[k].mode) assert_true(band > 0.06 && band < 0.075001);
    }
    context_close(&context);
}

/* The hills' slope is at most what a scene divides by, and nearly as much somewhere; heights are from 0 to 1.
 */
static void test_hills(void **state) {
    enum { SIDE = 512 };
    static float hills[4 * SIDE * SIDE];
    start(state);
    double steepest = 0, lowest = 1, highest = 0;
    support_evaluate(&context,
                     "#include \"distance/hills.glsl\"\n"
                     "vec4 evaluate(vec2 texel) {\n"
                     "    vec2 at = 0.073 * texel - 17.0;\n"
                     "    vec2 x = vec2(0.001, 0.0);\n"
                     "    vec2 z = vec2(0.0, 0.001);\n"
                     "    vec2 rise = vec2(hills(at + x) - hills(at - x), hills(at + z) - hills(at - z));\n"
                     "    return vec4(length(rise / 0.002), hills(at), HILLS_SLOPE, 0.0);\n}\n",
                     NULL, SIDE, SIDE, hills);
    for (int i = 0; i < SIDE * SIDE; i++) {
        steepest = fmax(steepest, (double)hills[4 * i]);
        lowest = fmin(lowest, (double)hills[4 * i + 1]);
        highest = fmax(highest, (double)hills[4 * i + 1]);
    }
    print_message("hills: slope up to %.3f, heights %.3f to %.3f\n", steepest, lowest, highest);
    assert_true(steepest < (double)hills[2] + 1e-3 && steepest > 0.8 * (double)hills[2]);
    assert_true(lowest >= 0 && lowest < 0.05 && highest <= 1 && highest > 0.95);
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_exact),          cmocka_unit_test(test_operators), cmocka_unit_test(test_march),
        cmocka_unit_test(test_march_in_bound), cmocka_unit_test(test_steep),     cmocka_unit_test(test_leave),
        cmocka_unit_test(test_grazing),        cmocka_unit_test(test_fence),     cmocka_unit_test(test_hills),
    };
    return cmocka_run_group_tests_name("distance", tests, support_folder, support_clean);
}
