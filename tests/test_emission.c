/* Surfaces that emit: in closed form, in furnaces, found by chance and by looking for them, and another
 * renderer's room. */
#include "failed.h"
#include "spread.h"
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const double pi = 3.14159265358979323846;

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

static double mean_of(const char *scene, const char *arguments, double *worst) {
    Image image = render(scene, arguments);
    double mean = 0;
    int pixels = image.width * image.height;
    for (int i = 0; i < pixels; i++) mean += (double)image.rgba[4 * i] / pixels;
    if (worst) *worst = 0;
    for (int i = 0; worst && i < pixels; i++)
        *worst = fmax(*worst, fabs((double)image.rgba[4 * i] / mean - 1));
    image_free(&image);
    return mean;
}

/* Directions toward named spheres are drawn as densely as is said: two that overlap, one alone, one below the
 * surface and one about the point itself, which are not to be drawn. */
static void test_density(void **state) {
    (void)state;
    enum { SIDE = 512, TEXELS = SIDE * SIDE, BINS = 64 * 64 };
    static float results[4 * TEXELS];
    static double counts[BINS], expected[BINS];
    static const char common[] =
        "#include \"math/hash.glsl\"\nconst int EMITTER_SPHERES = 5;\n"
        "vec4 emitter_sphere(int i) {\n"
        "    return i == 0 ? vec4(0.2, 0, 0, 1) : i == 1 ? vec4(1.5, 1, 1, 0.5) : i == 2 ? vec4(1.1, 1.2, "
        "0.8, 0.5) :\n           i == 3 ? vec4(-1, 2, 0, 0.4) : vec4(0, -3, 0, 0.5);\n}\n"
        "#include \"emission/cones.glsl\"\n"
        "vec3 normal = normalize(vec3(0.2, 1, -0.3));\n";
    char glsl[2048];
    Context context;
    double total = 0, chi2 = 0, degrees = -1;
    support_open(&context);
    snprintf(glsl, sizeof glsl,
             "%svec4 evaluate(vec2 t) {\n    float sum = 0.0;\n    for (int i = 0; i < 64; i++) {\n"
             "        vec2 s = (t + vec2(float(i %% 8) + 0.5, float(i / 8) + 0.5) / 8.0) / 512.0;\n"
             "        float z = 2.0 * s.x - 1.0, r = sqrt(1.0 - z * z), a = 2.0 * PI * s.y;\n"
             "        sum += emitters_pdf(vec3(0), normal, vec3(r * cos(a), r * sin(a), z)) / 64.0;\n    }\n"
             "    return vec4(sum, 0, 0, 0);\n}",
             common);
    support_evaluate(&context, glsl, NULL, SIDE, SIDE, results);
    for (int i = 0; i < TEXELS; i++) {
        double share = 4 * pi * (double)results[4 * i];
        expected[i % SIDE / 8 * 64 + i / SIDE / 8] += share;
        total += share / TEXELS;
    }
    snprintf(glsl, sizeof glsl,
             "%svec4 evaluate(vec2 t) {\n    uvec3 h = hash_3(uvec3(uvec2(t), 5u));\n"
             "    vec3 d = emitters_sample(vec3(0), normal, vec2(unit_float(h.x), unit_float(h.y)));\n"
             "    return vec4(0.5 + 0.5 * d.z, fract(atan(d.y, d.x) / (2.0 * PI) + 1.0), length(d), 0);\n}",
             common);
    support_evaluate(&context, glsl, NULL, SIDE, SIDE, results);
    context_close(&context);
    for (int i = 0; i < TEXELS; i++) {
        const float *v = results + 4 * i;
        assert_true(fabsf(v[2] - 1) < 1e-5f);
        counts[(int)fmin(v[0] * 64, 63) * 64 + (int)fmin(v[1] * 64, 63)]++;
    }
    for (int i = 0; i < BINS; i++) {
        if (expected[i] == 0) assert_true(counts[i] == 0);
        if (expected[i] < 10) continue;
        chi2 += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
        degrees++;
    }
    double off = ztest_chi_square(chi2, degrees);
    print_message("density: integral %.5f; chi-square %.1f off, %.0f degrees\n", total, off, degrees);
    assert_true(fabs(total - 1) < 1e-3 && degrees > 50 && fabs(off) < ztest_limit(1));
}

static const char lamp_over_plane[] =
    "//@ emitter-sphere 0 4 0 1\n//@ camera target 0 0 0 fov 0.2\n#include \"material/emitter.glsl\"\n"
    "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n#include \"shape/sphere.glsl\"\n"
    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
    "    hit_plane(ray, vec3(0, 1, 0), 0.0, 0, hit);\n    hit_sphere(ray, vec3(0, 4, 0), 1.0, 1, hit);\n}\n"
    "Material scene_material(Hit hit) { return hit.object == 1 ? emitter(vec3(5)) : matte(vec3(1)); }\n";

/* A sphere of radiance L wholly above the horizon gives E = pi L (R / d)^2 cos. Ground of albedo 1 has the
 * radiance E / pi, the lamp its own, and with one surface hit all of that is there. */
static void test_irradiance(void **state) {
    (void)state;
    static const double places[] = {0, 2, 5, 20};
    static const char *const lights[] = {"cosine", "mis", "control"};
    const char *scene = support_write("lamp.glsl", lamp_over_plane);
    char arguments[256];
    for (int i = 0; i < 12; i++) {
        double x = places[i / 3], squared = x * x + 16, expected = 5 / squared * 4 / sqrt(squared);
        snprintf(arguments, sizeof arguments,
                 "--sky uniform:%s --light %s --size 32x32 --spp 256 --depth %d --set camera.eye=%g,1,0 "
                 "--set camera.target=%g,0,0",
                 i % 3 == 1 ? "1e-9" : "0", lights[i % 3], 1 + i / 3, x, x);
        double got = mean_of(scene, arguments, NULL);
        print_message("%s at %g m: %.6f of %.6f\n", lights[i % 3], x, got, expected);
        /* A lamp that looking would not find would be found by the bounces with 12 % noise here. */
        assert_true(fabs(got / expected - 1) < (i % 3 == 1 ? 4e-3 : 1e-3));
    }
    double worst, lamp = mean_of(scene,
                                 "--sky uniform:0 --size 8x8 --spp 1 --depth 1 --set camera.eye=0,1,0 --set "
                                 "camera.target=0,4,0.1",
                                 &worst);
    assert_true(fabs(lamp - 5) < 1e-5 && worst < 1e-6);
}

static const char furnace[] =
    "%s//@ camera eye 0 0 -4 target 0 0 0 fov 70\n"
    "#include \"material/emitter.glsl\"\n#include \"material/matte.glsl\"\n#include "
    "\"material/mirror.glsl\"\n"
    "#include \"material/glass.glsl\"\n#include \"material/author.glsl\"\n#include \"shape/sphere.glsl\"\n"
    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n    hit_sphere(ray, vec3(0), 5.0, 0, hit);\n"
    "    hit_sphere(ray, vec3(-1, 0.9, 0), 0.9, 1, hit);\n    hit_sphere(ray, vec3(1, 0.9, 0), 0.9, 2, "
    "hit);\n"
    "    hit_sphere(ray, vec3(-1, -0.9, 0), 0.9, 3, hit);\n    hit_sphere(ray, vec3(1, -0.9, 0), 0.9, 4, "
    "hit);\n}\n"
    "Material scene_material(Hit hit) {\n    if (hit.object == 1) return matte(vec3(1));\n"
    "    if (hit.object == 2) return mirror(vec3(1));\n    if (hit.object == 3) return glass(1.5);\n"
    "    return hit.object == 4 ? author(vec3(1), 0.5, 0.3, 0.0) : emitter(vec3(1));\n}\n";

/* All albedos 1 within an emitting sphere of 1: every pixel is 1, with right hints, wrong ones, and none. */
static void test_furnace(void **state) {
    (void)state;
    static const char *const hints[] = {"", "//@ emitter-sphere 0 0 0 5\n//@ emitter-sphere 2 2 -2 1\n"
                                            "//@ emitter-sphere 0 -4 0 0.5\n//@ emitter-sphere 9 0 0 3\n"};
    static const char *const lights[] = {"cosine", "control", "mis", "paper"};
    for (int i = 0; i < 8; i++) {
        char text[4096], arguments[128];
        double worst;
        snprintf(text, sizeof text, furnace, hints[i / 4]);
        snprintf(arguments, sizeof arguments, "--sun 30 --light %s --size 64x64 --spp 256", lights[i % 4]);
        double mean = mean_of(support_write("furnace.glsl", text), arguments, &worst);
        print_message("furnace, %s, %s hints: %.5f, worst pixel %.3f off\n", lights[i % 4],
                      i / 4 ? "with" : "without", mean, worst);
        assert_true(fabs(mean - 1) < (i % 4 == 2 ? 5e-3 : 1.5e-3));
    }
}

/* A new material is one file. This one scatters and emits: a closed sphere of albedo a that emits 1 has the
 * radiance 1 + a + a^2 ..., of which --depth N keeps N + 1 terms. */
static void test_glow(void **state) {
    (void)state;
    static const double depths[] = {1, 2, 5, 0};
    static const char *const lights[] = {"cosine", "control", "mis"};
    assert_int_equal(mkdir(support_path("material"), 0777), 0);
    const char *material =
        support_write("material/glow.glsl",
                      "#include \"scene.glsl\"\n#include \"material/matte.glsl\"\n"
                      "Material glow(vec3 albedo) { return material_new(MATERIAL_GLOW, albedo); }\n"
                      "vec3 glow_emitted(Material m, vec3 normal, vec3 incoming) { return vec3(1); }\n"
                      "Bounce glow_sample(Material m, vec3 normal, vec3 incoming, vec2 u, vec2 v) {\n"
                      "    return matte_sample(m, normal, incoming, u, v);\n}\n"
                      "float glow_pdf(Material m, vec3 normal, vec3 incoming, vec3 outgoing) {\n"
                      "    return matte_pdf(m, normal, incoming, outgoing);\n}\n"
                      "vec3 glow_value(Material m, vec3 normal, vec3 incoming, vec3 outgoing) {\n"
                      "    return matte_value(m, normal, incoming, outgoing);\n}\n");
    const char *scene =
        support_write("glow.glsl", "//@ camera eye 1 0 0 target 0 0 0\n//@ emitter-sphere 2 0 0 0.5\n"
                                   "#include \"material/glow.glsl\"\n#include \"shape/sphere.glsl\"\n"
                                   "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_sphere(ray, vec3(0), "
                                   "3.0, 0, hit); }\n"
                                   "Material scene_material(Hit hit) { return glow(vec3(0.5)); }\n");
    for (int i = 0; i < 12; i++) {
        char arguments[128];
        double depth = depths[i / 3], expected = depth > 0 ? 2 - pow(0.5, depth) : 2;
        snprintf(arguments, sizeof arguments, "--sun 30 --light %s --size 64x64 --spp 256 --depth %.0f",
                 lights[i % 3], depth);
        double got = mean_of(scene, arguments, NULL);
        print_message("a glowing sphere, %s, depth %.0f: %.5f of %.5f\n", lights[i % 3], depth, got,
                      expected);
        assert_true(fabs(got / expected - 1) < (i % 3 == 2 ? 5e-3 : 1e-3));
    }
    unlink(material);
    rmdir(support_path("material"));
}

/* A round lamp and a square one, both named; a third that is not; a wrong hint; and all that reflects. The
 * ground is level, and a lamp hangs in a bound: light, blocker and bounce compete for the same directions. */
static const char lamps[] =
    "//@ camera eye 0 2 -5 target 0 0.8 0 fov 60\n//@ sun elevation 30 azimuth 120\n"
    "//@ bound -1 1.6 0 0.7\n//@ bound 1 0.6 0.5 0.6\n//@ mirror-sphere -0.4 0.4 -1.4 0.4\n%s"
    "#include \"material/author.glsl\"\n#include \"material/emitter.glsl\"\n#include "
    "\"material/matte.glsl\"\n"
    "#include \"material/mirror.glsl\"\n#include \"material/rough_metal.glsl\"\n"
    "#include \"shape/box.glsl\"\n#include \"shape/plane.glsl\"\n#include \"shape/sphere.glsl\"\n"
    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
    "    hit_plane(ray, vec3(0, 1, 0), 0.0, 0, hit);\n"
    "    hit_sphere(ray, vec3(-1, 1.6, 0), 0.7, 1, hit);\n"
    "    hit_box(ray, vec3(2, 1.5, 2), vec3(0.5), 1, hit);\n"
    "    hit_sphere(ray, vec3(1.2, 1.9, -1.2), 0.6, 1, hit);\n"
    "    hit_sphere(ray, vec3(1, 0.6, 0.5), 0.6, 2, hit);\n"
    "    hit_sphere(ray, vec3(-0.4, 0.4, -1.4), 0.4, 3, hit);\n"
    "    hit_sphere(ray, vec3(-2, 0.5, 1), 0.5, 4, hit);\n}\n"
    "Material scene_material(Hit hit) {\n    if (hit.object == 1) return emitter(vec3(2, 1.5, 1));\n"
    "    if (hit.object == 2) return rough_metal(gold(), 0.5);\n"
    "    if (hit.object == 3) return mirror(vec3(0.9));\n"
    "    return hit.object == 4 ? author(vec3(0.8), 0.5, 0.4, 0.1) : matte(vec3(0.6));\n}\n";

/* Looking for the lamps changes no pixel's mean, whatever else the bounces look for. */
static void test_chance(void **state) {
    (void)state;
    static const char *const lights[] = {"cosine", "control", "mis", "control --sun-disk", "paper"};
    static Spread chance, sampled;
    char text[4096];
    snprintf(text, sizeof text, lamps, "");
    const char *without = support_write("chance.glsl", text);
    snprintf(text, sizeof text, lamps,
             "//@ emitter-sphere -1 1.6 0 0.7\n//@ emitter-sphere 2 1.5 2 0.87\n"
             "//@ emitter-sphere 0 0.5 3 0.8\n");
    const char *with = support_write("sampled.glsl", text);
    ZTest pool = {0};
    for (int i = 0; i < 5; i++) {
        char arguments[128], name[128];
        const char *plain = i < 3 ? "cosine" : i == 3 ? "cosine --sun-disk" : "paper";
        snprintf(arguments, sizeof arguments, "--size 32x32 --spp 1024 --sequence random --light %s", plain);
        if (i == 0 || i > 2) spread_render(without, arguments, 0, &chance);
        snprintf(arguments, sizeof arguments, "--size 32x32 --spp 1024 --sequence %s --light %s",
                 i % 2 ? "sobol" : "random", lights[i]);
        spread_render(with, arguments, 100, &sampled);
        snprintf(name, sizeof name, "lamps, %s", lights[i]);
        spread_expect_same(name, &sampled, &chance, 5, &pool);
    }
    spread_expect_pool("lamps, all lights", &pool);
}

/* What a scene does not use is not compiled. */
static void test_compiled(void **state) {
    (void)state;
    static const char *const words[] = {"material_emitted(", "MATERIAL_EMITTER", "emitters_sample(",
                                        "cone_sample("};
    char text[4096];
    snprintf(text, sizeof text, furnace, "");
    const char *scenes[] = {"scenes/furnace.glsl", support_write("chance.glsl", text),
                            support_write("lamp.glsl", lamp_over_plane)};
    static const int there[3][4] = {{0, 0, 0, 0}, {1, 1, 0, 0}, {1, 1, 1, 1}};
    for (int i = 0; i < 12; i++) {
        assert_int_equal(support_run("", "flatten '%s' --light cosine", scenes[i / 4]), 0);
        bool found = strstr(support_out, words[i % 4]) != NULL;
        if (found != there[i / 4][i % 4]) fail_msg("%s: %s", scenes[i / 4], words[i % 4]);
    }
}

/* Mitsuba's box room (tools/peer_box_room.py), pixel by pixel off edges: within its standard errors, ours,
 * and the rounding of its halves. */
static void test_another_renderer(void **state) {
    (void)state;
    enum { SIZE = 128 };
    static Spread ours;
    ZTest test = {.together = 3};
    Image reference, se;
    Error error;
    double sums[2][3] = {{0}};
    /* The reference's noise is known by pixel only. */
    if (support_block() > 1) skip();
    spread_render("scenes/box-room.glsl", "--size 128x128 --spp 256 --sequence random", 0, &ours);
    if (!image_read(&reference, "tests/data/box_room.exr", &error) ||
        !image_read(&se, "tests/data/box_room_se.exr", &error))
        fail_msg("%s", error.text);
    for (int i = 0; i < ours.values; i++) {
        int x = i / 3 % SIZE, y = i / 3 / SIZE, at = 4 * (i / 3) + i % 3;
        sums[0][i % 3] += ours.mean[i];
        sums[1][i % 3] += (double)reference.rgba[at];
        if (y < 2 || y > SIZE - 3 || x < 2 || x > SIZE - 3 || !spread_even_around(&reference, x, y)) continue;
        double own = (double)se.rgba[at], v = ours.variance[i];
        double both = own * own + v + pow(3e-4 * ours.mean[i], 2);
        ztest_add(&test, ours.mean[i] - (double)reference.rgba[at], both,
                  (SPREAD_SEEDS - 1) * both * both / (v * v));
    }
    for (int c = 0; c < 3; c++) {
        print_message("channel %d: means differ by %+.3f %%\n", c, 100 * (sums[0][c] / sums[1][c] - 1));
        assert_true(fabs(sums[0][c] / sums[1][c] - 1) < 5e-3);
    }
    assert_true(test.count > SIZE * SIZE);
    double mean = test.z2 / (double)test.count, far = test.far / (double)test.count;
    print_message("box room: mean z^2 %.3f, |z| > 4 in %.2f %% of %ld values off edges\n", mean, 100 * far,
                  test.count);
    /* Its standard errors are estimates, of noise that is not normal. */
    if (mean > 1.6 || far > 0.01) {
        Image got = spread_image(&ours);
        failed_keep("box room", &got, &reference);
        image_free(&got);
        fail_msg("another picture than the reference");
    }
    image_free(&reference);
    image_free(&se);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_density),          cmocka_unit_test(test_irradiance),
        cmocka_unit_test(test_furnace),          cmocka_unit_test(test_glow),
        cmocka_unit_test(test_chance),           cmocka_unit_test(test_compiled),
        cmocka_unit_test(test_another_renderer),
    };
    return cmocka_run_group_tests_name("emission", tests, support_folder, support_clean);
}
