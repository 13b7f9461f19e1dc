/* Light by way of portals, the openings that a scene names: directions are drawn as densely as is said, and
 * whatever the portals are the picture is that of the bounces alone. */
#include "spread.h"
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* Five portals: two that overlap, one small, one that faces away, and one below the surface. */
static const char openings[] =
    "#include \"math/hash.glsl\"\n#include \"math/rectangle.glsl\"\nconst int SCENE_PORTALS = 5;\n"
    "mat3 scene_portal(int i) {\n"
    "    if (i == 0) return rectangle_facing(-2.0, 1.0, 0.0, 90.0, 0.0, 3.0, 1.5);\n"
    "    if (i == 1) return rectangle_facing(-1.8, 1.0, 0.5, 100.0, -20.0, 1.0, 2.0);\n"
    "    if (i == 2) return rectangle_facing(0.5, 3.0, 0.5, 30.0, -90.0, 0.4, 0.2);\n"
    "    if (i == 3) return rectangle_facing(2.0, 1.0, 0.0, 90.0, 0.0, 3.0, 3.0);\n"
    "    return rectangle_facing(0.0, -3.0, 0.0, 0.0, 90.0, 2.0, 2.0);\n}\n"
    "#include \"light/openings.glsl\"\n"
    "vec3 normal = normalize(vec3(-0.2, 1.0, 0.3));\n"
    "Openings seen = openings_seen(vec3(%s), normal);\n";

enum { SIDE = 512, TEXELS = SIDE * SIDE, BINS = 64 * 64 };
static float results[4 * TEXELS];

/* Sums the density of each bin of directions, from 64 directions a texel. */
static double integrate(const Context *context, const char *common, double *expected) {
    char glsl[4096];
    double total = 0;
    snprintf(glsl, sizeof glsl,
             "%svec4 evaluate(vec2 t) {\n    float sum = 0.0;\n    for (int i = 0; i < 64; i++) {\n"
             "        vec2 s = (t + vec2(float(i %% 8) + 0.5, float(i / 8) + 0.5) / 8.0) / 512.0;\n"
             "        float z = 2.0 * s.x - 1.0, r = sqrt(1.0 - z * z), a = 2.0 * PI * s.y;\n"
             "        sum += openings_pdf(seen, vec3(r * cos(a), r * sin(a), z)) / 64.0;\n    }\n"
             "    return vec4(sum, 0, 0, 0);\n}",
             common);
    support_evaluate(context, glsl, NULL, SIDE, SIDE, results);
    memset(expected, 0, sizeof(double[BINS]));
    for (int i = 0; i < TEXELS; i++) {
        double share = 4 * pi * (double)results[4 * i];
        expected[i % SIDE / 8 * 64 + i / SIDE / 8] += share;
        total += share / TEXELS;
    }
    return total;
}

static void count(const Context *context, const char *common, double *counts) {
    char glsl[4096];
    snprintf(glsl, sizeof glsl,
             "%svec4 evaluate(vec2 t) {\n    uvec3 h = hash_3(uvec3(uvec2(t), 5u));\n"
             "    vec3 d = openings_sample(seen, normal, vec2(unit_float(h.x), unit_float(h.y)));\n"
             "    return vec4(0.5 + 0.5 * d.z, fract(atan(d.y, d.x) / (2.0 * PI) + 1.0), length(d), 0);\n}",
             common);
    support_evaluate(context, glsl, NULL, SIDE, SIDE, results);
    memset(counts, 0, sizeof(double[BINS]));
    for (int i = 0; i < TEXELS; i++) {
        const float *v = results + 4 * i;
        assert_true(fabsf(v[2] - 1) < 1e-5f);
        counts[(int)fmin(v[0] * 64, 63) * 64 + (int)fmin(v[1] * 64, 63)]++;
    }
}

/* The density integrates to 1 and is that of the directions drawn: from the middle, close to a portal's face,
 * so close to its plane that it is seen edge-on, far off, and where only the small one is before the point.
 */
static void test_density(void **state) {
    (void)state;
    static const char *const places[] = {"0.0, 0.0, 0.0", "-1.7, 0.9, -1.0", "-1.6, 0.5, 3.0",
                                         "3.0, 0.0, 1.0", "-2.5, 0.0, 0.0"};
    static double counts[BINS], expected[BINS];
    Context context;
    support_open(&context);
    for (int p = 0; p < 5; p++) {
        char common[2048];
        double chi2 = 0, degrees = -1;
        snprintf(common, sizeof common, openings, places[p]);
        double total = integrate(&context, common, expected);
        count(&context, common, counts);
        for (int i = 0; i < BINS; i++) {
            /* A bin that the 4096 directions of its texels missed may still hold a sliver of the edge. */
            if (expected[i] == 0) assert_true(counts[i] < 1e-4 * TEXELS);
            if (expected[i] < 10) continue;
            chi2 += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
            degrees++;
        }
        print_message("from %s: integral %.5f, %.0f degrees\n", places[p], total, degrees);
        assert_true(fabs(total - 1) < 5e-3);
        if (degrees > 3 && fabs(ztest_chi_square(chi2, degrees)) > ztest_limit(5))
            fail_msg("from %s: chi-square is %.1f off", places[p], ztest_chi_square(chi2, degrees));
    }
    context_close(&context);
}

/* A room with a window, a narrow second one and a skylight, and something of every material in it. */
static const char room[] =
    "//@ camera eye 1.6 1.4 -2.2 target -0.8 1.0 1.5 fov 70\n//@ sun elevation 20 azimuth 250\n%s"
    "#include \"material/author.glsl\"\n#include \"material/emitter.glsl\"\n"
    "#include \"material/glass.glsl\"\n#include \"material/matte.glsl\"\n#include \"material/mirror.glsl\"\n"
    "#include \"material/rough_metal.glsl\"\n#include \"shape/box.glsl\"\n#include \"shape/plane.glsl\"\n"
    "#include \"shape/sphere.glsl\"\n"
    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
    "    hit_plane(ray, vec3(0.0, 1.0, 0.0), -0.3, 0, hit);\n"
    "    hit_box(ray, vec3(0.0, -0.1, 0.0), vec3(2.2, 0.15, 3.2), 0, hit);\n"
    "    hit_box(ray, vec3(0.0, 2.7, -1.2), vec3(2.2, 0.1, 2.0), 0, hit);\n"
    "    hit_box(ray, vec3(-0.9, 2.7, 2.0), vec3(1.3, 0.1, 1.3), 0, hit);\n"
    "    hit_box(ray, vec3(2.1, 1.3, 0.0), vec3(0.1, 1.4, 3.2), 0, hit);\n"
    "    hit_box(ray, vec3(0.0, 1.3, -3.1), vec3(2.2, 1.4, 0.1), 0, hit);\n"
    "    hit_box(ray, vec3(-0.3, 1.3, 3.1), vec3(1.9, 1.4, 0.1), 0, hit);\n"
    "    hit_box(ray, vec3(-2.1, 0.4, 0.0), vec3(0.1, 0.5, 3.2), 0, hit);\n"
    "    hit_box(ray, vec3(-2.1, 2.4, 0.0), vec3(0.1, 0.3, 3.2), 0, hit);\n"
    "    hit_box(ray, vec3(-2.1, 1.3, -2.0), vec3(0.1, 1.4, 1.2), 0, hit);\n"
    "    hit_box(ray, vec3(-2.1, 1.3, 2.0), vec3(0.1, 1.4, 1.2), 0, hit);\n"
    "    hit_box(ray, vec3(-0.9, 0.375, 1.4), vec3(0.5, 0.425, 0.5), 1, hit);\n"
    "    hit_sphere(ray, vec3(0.1, 0.45, 1.2), 0.4, 2, hit);\n"
    "    hit_sphere(ray, vec3(0.9, 0.35, 0.6), 0.3, 3, hit);\n"
    "    hit_sphere(ray, vec3(-0.8, 0.35, -0.2), 0.3, 4, hit);\n"
    "    hit_sphere(ray, vec3(0.2, 0.3, -0.3), 0.25, 5, hit);\n"
    "    hit_sphere(ray, vec3(-1.5, 2.2, 2.5), 0.1, 6, hit);\n}\n"
    "Material scene_material(Hit hit) {\n    if (hit.object == 1) return author(vec3(0.8), 0.5, 0.4, 0.1);\n"
    "    if (hit.object == 2) return rough_metal(gold(), 0.5);\n"
    "    if (hit.object == 3) return mirror(vec3(0.9));\n"
    "    if (hit.object == 4) return glass(1.5);\n"
    "    if (hit.object == 5) return matte(vec3(0.2, 0.35, 0.7));\n"
    "    return hit.object == 6 ? emitter(vec3(0.3, 0.2, 0.1)) : matte(vec3(0.6));\n}\n";

#define WINDOW "//@ portal -2.2 1.5 0 90 0 1.6 1.2\n"
#define LAMP "//@ emitter-sphere -1.5 2.2 2.5 0.1\n"

static const struct {
    const char *name, *hints, *arguments;
} rooms[] = {
    {"none", "", ""},
    {"one of three", WINDOW, ""},
    {"three", WINDOW "//@ portal 1.8 1.3 3.2 180 0 0.4 2.8\n//@ portal 1.3 2.8 2.0 0 -90 1.8 2.4\n", ""},
    {"one twice, a part of it, and a larger one",
     WINDOW WINDOW "//@ portal -2 1.6 0.3 80 5 0.5 0.5\n//@ portal -2.2 1.3 0 90 0 6 2.6\n", ""},
    /* Within the room, behind a wall, facing out, edge-on to the floor, and all at once. */
    {"within the room", "//@ portal 0 1 0.5 40 10 1.5 1.2\n", ""},
    {"behind a wall", "//@ portal 2.5 1.3 0 -90 0 3 2\n", ""},
    {"facing out", "//@ portal -2 1.5 0 -90 0 1.6 1.2\n", ""},
    {"in the floor's plane", "//@ portal 0 0.05 0.5 0 90 1 1\n//@ portal -1 0.05 0.5 0 -90 2 2\n", ""},
    {"right and wrong", WINDOW "//@ portal 0 1 0.5 40 10 1.5 1.2\n//@ portal 2.5 1.3 0 -90 0 3 2\n", ""},
    {"from outside", WINDOW "//@ portal 1.3 2.8 2 0 -90 1.8 2.4\n",
     "--set camera.eye=-7,4,-5 --set camera.target=0,1,0 --set camera.fov=30"},
    {"with the sun's disk and a lamp", WINDOW LAMP, "--sun-disk --set sun.radius=8"},
};

/* A room's portals change no pixel's mean, be they right or wrong. */
static void test_rooms(void **state) {
    (void)state;
    enum { ROOMS = sizeof rooms / sizeof *rooms };
    static Spread bounced, sent;
    char text[8192], arguments[256], before[256] = "none yet";
    ZTest pool = {0};
    for (int i = 0; i < ROOMS; i++) {
        snprintf(arguments, sizeof arguments,
                 "--size 32x32 --spp 256 --sky table:gauss:4@16x48 --orders 1 --sequence random --light "
                 "cosine %s",
                 rooms[i].arguments);
        snprintf(text, sizeof text, room, "");
        if (strcmp(arguments, before) != 0)
            spread_render(support_write("without.glsl", text), arguments, 0, &bounced);
        snprintf(before, sizeof before, "%s", arguments);
        snprintf(
            arguments, sizeof arguments,
            "--size 32x32 --spp 256 --sky table:gauss:4@16x48 --orders 1 --sequence %s --light portal %s",
            i % 2 ? "sobol" : "random", rooms[i].arguments);
        snprintf(text, sizeof text, room, rooms[i].hints);
        spread_render(support_write("with.glsl", text), arguments, 100, &sent);
        spread_expect_same(rooms[i].name, &sent, &bounced, ROOMS, &pool);
    }
    spread_expect_pool("all portals", &pool);
}

static Image render(const char *scene, const char *arguments) {
    Image image;
    Error error;
    int status =
        support_run("", "render '%s' --quiet %s -o '%s'", scene, arguments, support_path("picture.pfm"));
    if (status == STATUS_NO_GL) support_no_gl(support_err);
    if (status != 0) fail_msg("render %s: %s", arguments, support_err);
    if (!image_read(&image, support_path("picture.pfm"), &error)) fail_msg("%s", error.text);
    return image;
}

/* A box of one albedo, one of whose sides has an opening. */
static const char box[] =
    "//@ camera eye 0.5 0.2 -0.8 target -0.5 0 0.6 fov 80\n//@ sky uniform:1\n"
    "#include \"material/matte.glsl\"\n#include \"shape/box.glsl\"\n"
    "uniform float high; //@ slider 1.2 min 0.1 max 2\n%s"
    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
    "    hit_box(ray, vec3(1.2, 0.0, 0.0), vec3(0.2, 1.4, 1.4), 0, hit);\n"
    "    hit_box(ray, vec3(0.0, 1.2, 0.0), vec3(1.4, 0.2, 1.4), 0, hit);\n"
    "    hit_box(ray, vec3(0.0, -1.2, 0.0), vec3(1.4, 0.2, 1.4), 0, hit);\n"
    "    hit_box(ray, vec3(0.0, 0.0, 1.2), vec3(1.4, 1.4, 0.2), 0, hit);\n"
    "    hit_box(ray, vec3(0.0, 0.0, -1.2), vec3(1.4, 1.4, 0.2), 0, hit);\n"
    "    hit_box(ray, vec3(-1.2, 0.7 + 0.5 * high, 0.0), vec3(0.2, 0.7, 1.4), 0, hit);\n"
    "    hit_box(ray, vec3(-1.2, -0.7 - 0.5 * high, 0.0), vec3(0.2, 0.7, 1.4), 0, hit);\n}\n"
    "Material scene_material(Hit hit) { return matte(vec3(%s)); }\n";

#define OPENING "//@ portal -1.4 0 0 90 0 2 high\n"
/* The edges need not be perpendicular: only a part of the second one counts. */
#define OPENING_IN_GLSL                                                                                      \
    "const int SCENE_PORTALS = 1;\nmat3 scene_portal(int i) {\n    return mat3(vec3(-1.4, 0.0, 0.0), "       \
    "vec3(0.0, 0.0, -1.0), vec3(0.0, 0.5 * high, 0.0));\n}\n"
#define SKEW_IN_GLSL                                                                                         \
    "const int SCENE_PORTALS = 1;\nmat3 scene_portal(int i) {\n    return mat3(vec3(-1.4, 0.0, 0.0), "       \
    "vec3(0.0, 0.0, -1.0), vec3(0.0, 0.5 * high, 0.3));\n}\n"

/* A white box under a sky of 1 is 1 everywhere, whichever part of the sky is met by rays and by bounces. */
static void test_furnace(void **state) {
    (void)state;
    static const char *const hints[] = {OPENING, OPENING "//@ portal 0 0 0 0 0 1 1\n", SKEW_IN_GLSL};
    for (int i = 0; i < 3; i++) {
        char text[4096];
        double mean = 0;
        snprintf(text, sizeof text, box, hints[i], "1.0");
        Image image = render(support_write("furnace.glsl", text), "--size 64x64 --spp 256 --light portal");
        for (int k = 0; k < 64 * 64; k++) mean += (double)image.rgba[4 * k] / (64 * 64);
        image_free(&image);
        print_message("furnace, portals %d: %.5f\n", i, mean);
        assert_true(fabs(mean - 1) < 5e-3);
    }
}

/* The annotation and the same rectangle in GLSL find the same light, after a slider has moved too. */
static void test_in_glsl(void **state) {
    (void)state;
    static const char *const arguments[] = {"--size 24x24 --spp 16 --light portal",
                                            "--size 24x24 --spp 16 --light portal --set high=0.4"};
    for (int i = 0; i < 2; i++) {
        char text[4096];
        snprintf(text, sizeof text, box, OPENING, "0.6");
        Image a = render(support_write("annotated.glsl", text), arguments[i]);
        snprintf(text, sizeof text, box, OPENING_IN_GLSL, "0.6");
        Image b = render(support_write("defined.glsl", text), arguments[i]);
        int differ = 0;
        /* Roundings differ, and a few paths pass an edge on its other side. */
        for (int k = 0; k < 24 * 24; k++) differ += fabsf(a.rgba[4 * k] - b.rgba[4 * k]) > 1e-3f;
        print_message("%d pixels differ\n", differ);
        assert_true(differ < 24 * 24 / 50);
        image_free(&a);
        image_free(&b);
    }
}

/* The variance of a pixel, from eight seeds, over all pixels. */
static double variance_of(const char *scene, const char *arguments) {
    static Spread spread;
    double sum = 0;
    spread_render(scene, arguments, 0, &spread);
    for (int i = 0; i < spread.values; i++) sum += spread.variance[i];
    return sum;
}

/* In a room with a small window the rays find most of the light, and the noise is less. A room that does not
 * name its window has the bounces' noise. */
static void test_noise(void **state) {
    (void)state;
    char named[4096], unnamed[4096];
    /* Few samples tell no variance. */
    if (support_block() > 1) skip();
    snprintf(named, sizeof named, box, OPENING, "0.7");
    snprintf(unnamed, sizeof unnamed, box, "", "0.7");
    const char *with = support_write("named.glsl", named), *without = support_write("unnamed.glsl", unnamed);
    double cosine = variance_of(with, "--size 24x24 --spp 256 --set high=0.3 --light cosine");
    double portal = variance_of(with, "--size 24x24 --spp 256 --set high=0.3 --light portal");
    double none = variance_of(without, "--size 24x24 --spp 256 --set high=0.3 --light portal");
    print_message("variance: cosine 1, portal 1/%.1f, without a portal %.2f\n", cosine / portal,
                  none / cosine);
    assert_true(cosine > 4 * portal);
    assert_true(fabs(none / cosine - 1) < 0.1);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_density), cmocka_unit_test(test_furnace), cmocka_unit_test(test_in_glsl),
        cmocka_unit_test(test_noise),   cmocka_unit_test(test_rooms),
    };
    return cmocka_run_group_tests_name("portal", tests, support_folder, support_clean);
}
