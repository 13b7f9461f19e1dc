/* Pictures with mist: another renderer's, furnaces, a second driver, and the error that is promised. */
#include "drivers.h"
#include "mist.h"
#include "spread.h"
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CRATER(annotations, ground, ball)                                                                    \
    "//@ camera eye 0 2 -4 target 0 0 0 fov 90\n//@ size 128 128\n" annotations                              \
    "#include \"color/checker.glsl\"\n#include \"material/matte.glsl\"\n#include \"material/mirror.glsl\"\n" \
    "#include \"shape/plane_minus_sphere.glsl\"\n#include \"shape/sphere.glsl\"\n"                           \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"                                                      \
    "    hit_plane_minus_sphere(ray, vec3(0.0, 1.0, 0.0), 0.0, vec3(0.0), 2.0, 0, hit);\n"                   \
    "    hit_sphere(ray, vec3(0.0, 0.5, 0.0), 1.0, 1, hit);\n}\n"                                            \
    "Material scene_material(Hit hit) {\n    if (hit.object == 1) return " ball ";\n"                        \
    "    return " ground ";\n}\n"
#define CHECKER "matte(checker(hit.position, vec3(0.8), vec3(0.1)))"
#define MIRROR "mirror(vec3(1.0))"
#define MATTE "matte(vec3(0.5))"
#define WHITE "matte(vec3(1.0))"

/* A room with four slits in its back wall. */
#define SLITS(annotations)                                                                                   \
    "//@ camera eye 0.8 1.4 -4.5 target 0 1.5 0 fov 70\n//@ size 128 128\n"                                  \
    "//@ sun elevation 25 azimuth 22.5\n//@ sun-disk on\n" annotations                                       \
    "#include \"material/matte.glsl\"\n#include \"shape/box.glsl\"\n#include \"shape/plane.glsl\"\n"         \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"                                                      \
    "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n"                                                \
    "    for (int i = 0; i < 5; i++)\n"                                                                      \
    "        hit_box(ray, vec3(-2.8 + 1.4 * float(i), 2.0, 3.1), vec3(0.5, 2.0, 0.1), 1, hit);\n"            \
    "    hit_box(ray, vec3(0.0, 3.5, 3.1), vec3(3.3, 0.5, 0.1), 1, hit);\n"                                  \
    "    hit_box(ray, vec3(-3.1, 2.0, 0.0), vec3(0.1, 2.0, 3.2), 1, hit);\n"                                 \
    "    hit_box(ray, vec3(3.1, 2.0, 0.0), vec3(0.1, 2.0, 3.2), 1, hit);\n"                                  \
    "    hit_box(ray, vec3(0.0, 4.1, 0.0), vec3(3.3, 0.1, 3.3), 1, hit);\n}\n"                               \
    "Material scene_material(Hit hit) { return matte(vec3(hit.object == 0 ? 0.4 : 0.6)); }\n"

static const char crater_sky[] = CRATER("//@ sun elevation 30 azimuth 0\n"
                                        "//@ mist extinction 0.15 albedo 0.9 0.9 0.9 g 0.6 sphere 0 0 0 8\n",
                                        CHECKER, MIRROR);
static const char crater_sun[] = CRATER("//@ sun elevation 15 azimuth 90\n//@ sun-disk on\n"
                                        "//@ mist extinction 0.15 albedo 0.9 0.9 0.9 g 0.6 sphere 0 0 0 8\n",
                                        CHECKER, MATTE);
static const char crater_colour[] = CRATER("//@ sun elevation 30 azimuth 0\n"
                                           "//@ mist extinction 0.3 albedo 0.95 0.7 0.4 box 0 -0.5 0 6 2 6\n",
                                           CHECKER, MIRROR);
static const char crater_height[] =
    CRATER("//@ sun elevation 20 azimuth 90\n//@ sun-disk on\n"
           "//@ mist extinction 0.6 falloff 1 base -2 albedo 0.9 0.9 0.9 g 0.5 "
           "box 0 1.5 0 10 4 10\n",
           CHECKER, MATTE);
static const char slits_thin[] =
    SLITS("//@ mist extinction 0.02 albedo 0.95 0.95 0.95 g 0.6 sphere 0 0 0 8\n");

static const char slits_waves[] = SLITS(
    "//@ mist extinction 0.1 albedo 0.95 0.95 0.95 g 0.6 box 0 2.5 0 6 3 6\n"
    "float scene_mist(vec3 p) { return 0.5 + 0.5 * sin(2.0 * p.x) * sin(3.0 * p.y) * sin(2.0 * p.z); }\n");

static const char slits_coloured[] = SLITS("//@ mist extinction 0.1 0.3 0.2 g 0.6 box 0 2.5 0 6 3 6\n"
                                           "float scene_mist(vec3 p) { return fract(2.0 * p.y); }\n");

static const struct {
    const char *name, *text, *light;
    /* How far the mean may be from the reference's, percent, beside the noise. */
    double mean_percent;
} references[] = {
    {"crater_sky", crater_sky, "cosine", 0.15},       {"crater_sky", crater_sky, "mis", 0.15},
    {"crater_sun", crater_sun, "cosine", 0.15},       {"crater_colour", crater_colour, "cosine", 0.15},
    {"crater_height", crater_height, "cosine", 0.15}, {"slits_thin", slits_thin, "cosine", 0.15},
    {"slits_waves", slits_waves, "cosine", 0.3},
};

enum { BLOCKS = 16, VALUES = 3 * BLOCKS * BLOCKS, SEEDS = 8 };

static void add_blocks(const Image *image, double *blocks) {
    int side = image->width / BLOCKS;
    memset(blocks, 0, sizeof(double[VALUES]));
    for (int i = 0; i < image->width * image->height; i++) {
        int block = i / image->width / side * BLOCKS + i % image->width / side;
        for (int c = 0; c < 3; c++) blocks[3 * block + c] += (double)image->rgba[4 * i + c] / (side * side);
    }
}

/* A scene's blocks: their means over the seeds, and the variance of these. */
static void measure(const char *scene, const char *light, double *mean, double *variance) {
    static double blocks[SEEDS][VALUES];
    char arguments[128];
    for (int seed = 0; seed < SEEDS; seed++) {
        snprintf(arguments, sizeof arguments, "--light %s --seed %d --spp %d", light, seed,
                 (int)support_samples(128));
        Image image = mist_render("", scene, arguments);
        add_blocks(&image, blocks[seed]);
        image_free(&image);
    }
    for (int i = 0; i < VALUES; i++) {
        double sum = 0, squares = 0;
        for (int seed = 0; seed < SEEDS; seed++) sum += blocks[seed][i] / SEEDS;
        for (int seed = 0; seed < SEEDS; seed++) squares += pow(blocks[seed][i] - sum, 2);
        mean[i] = sum;
        variance[i] = squares / (SEEDS - 1) / SEEDS;
    }
}

static void read_blocks(const char *name, const char *suffix, Image *image) {
    char path[256];
    Error error;
    snprintf(path, sizeof path, "tests/data/mist_%s%s.exr", name, suffix);
    if (!image_read(image, path, &error)) fail_msg("%s", error.text);
    assert_int_equal(image->width, BLOCKS);
}

/* Another renderer's pictures as blocks of 8x8 pixels with their standard errors. The sky that it was given
 * is good to a thousandth. */
static void test_references(void **state) {
    (void)state;
    static double mean[VALUES], variance[VALUES];
    for (size_t i = 0; i < sizeof references / sizeof *references; i++) {
        Image wanted, error_of;
        double got_sum = 0, wanted_sum = 0, noise = 0, z2 = 0;
        int count = 0;
        char file[64];
        snprintf(file, sizeof file, "%s.glsl", references[i].name);
        measure(support_write(file, references[i].text), references[i].light, mean, variance);
        read_blocks(references[i].name, "", &wanted);
        read_blocks(references[i].name, "_se", &error_of);
        for (int k = 0; k < VALUES; k++) {
            double value = (double)wanted.rgba[k / 3 * 4 + k % 3],
                   own = (double)error_of.rgba[k / 3 * 4 + k % 3];
            got_sum += mean[k];
            wanted_sum += value;
            noise += own * own + variance[k];
            if (own <= 0) continue;
            /* The square of a difference over its variance from n pictures is (n - 1) / (n - 3) on average.
             */
            double mine = variance[k] * (SEEDS - 1) / (SEEDS - 3);
            z2 += pow(mean[k] - value, 2) / (own * own + 1e-6 * value * value + mine);
            count++;
        }
        double off = 100 * (got_sum / wanted_sum - 1);
        /* The three channels of a block have the same noise. */
        double error = 100 * sqrt(3 * noise) / wanted_sum;
        print_message("%s, %s: mean %+.3f %%, standard error %.3f %%, mean z^2 of %d blocks' values %.2f\n",
                      references[i].name, references[i].light, off, error, count, z2 / count);
        /* Edges have no standard error in the data, and their noise is not in `error`. */
        assert_true(fabs(off) < references[i].mean_percent + 3 * error);
        if (support_block() == 1) assert_true(fabs(off) < references[i].mean_percent);
        assert_true(count > VALUES / 4);
        assert_true(z2 / count < 2);
        image_free(&wanted);
        image_free(&error_of);
    }
}

/* White mist among white surfaces under a sky of 1 cannot be seen, from without and from within. */
static void test_furnace(void **state) {
    (void)state;
    static const struct {
        const char *mist, *arguments;
    } cases[] = {
        {"extinction 0.15 g 0.6 sphere 0 0 0 8", "--light cosine"},
        {"extinction 0.15 g 0.6 sphere 0 0 0 8", "--light mis"},
        {"extinction 0.15 g 0.6 sphere 0 0 0 8", "--light control"},
        {"extinction 0.3 g -0.3 sphere 0 0 0 3", "--light cosine"},
        {"extinction 0.3 box 0 -0.5 0 6 2 6", "--light cosine"},
        {"extinction 0.3 box 0 -0.5 0 6 2 6", "--light cosine --set camera.eye=0,0.5,-3"},
        {"extinction 0.2 phase shanks g 0.7 below 1", "--light cosine"},
        {"extinction 0.6 falloff 1 base -2 g 0.5 box 0 1.5 0 10 4 10", "--light cosine"},
        {"extinction 0.2 falloff 3", "--light mis"},
        {"extinction 0.1 0.3 0 g 0.5 sphere 0 0 0 8", "--light cosine"},
        {"extinction 0.1 0.3 0 falloff 2", "--light control"},
        {"extinction 0.5 0.1 0.2 box 0 -0.5 0 6 2 6", "--light mis"},
        {"extinction 0.3 0.05 0.1 g 0.4 sphere 0 0 0 8\nfloat scene_mist(vec3 p) { return fract(p.x); }",
         "--light cosine"},
        {"extinction 0.2 falloff 3", "--light portal --set camera.eye=0,12,-4"},
        {"extinction 0.3 g 0.4 sphere 0 0 0 8\nfloat scene_mist(vec3 p) { return fract(p.x); }",
         "--light cosine"},
        {"extinction 0.4 falloff 2 box 0 1 0 3 2 3\nfloat scene_mist(vec3 p) { return fract(p.x + 2.0 * "
         "p.y); }",
         "--light mis --set camera.eye=0,1,-2.5"},
    };
    enum { CASES = sizeof cases / sizeof *cases };
    double all = 0, all_variance = 0;
    for (int i = 0; i < CASES; i++) {
        char text[4096], arguments[256];
        double mean = 0, squares = 0;
        snprintf(text, sizeof text, CRATER("//@ sky uniform:1\n//@ mist %s\n", WHITE, WHITE), cases[i].mist);
        snprintf(arguments, sizeof arguments, "--seed %d --spp %d %s", i, (int)support_samples(256),
                 cases[i].arguments);
        Image image = mist_render("", support_write("furnace.glsl", text), arguments);
        int pixels = image.width * image.height;
        /* Each furnace by another channel. */
        for (int k = 0; k < pixels; k++) {
            mean += (double)image.rgba[4 * k + i % 3] / pixels;
            squares += pow((double)image.rgba[4 * k + i % 3] - 1, 2);
        }
        image_free(&image);
        double variance = squares / pixels / pixels;
        print_message("%s, %s: %.6f, standard error %.6f\n", cases[i].mist, cases[i].arguments, mean,
                      sqrt(variance));
        assert_true(fabs(mean - 1) <= ztest_limit(CASES) * sqrt(variance) + 1e-5);
        all += (mean - 1) / CASES;
        all_variance += variance / CASES / CASES;
    }
    print_message("all: %+.6f, standard error %.6f\n", all, sqrt(all_variance));
    if (support_block() == 1) assert_true(fabs(all) < 1e-4);
}

/* llvmpipe is known to compile loops wrongly without a word, so that each kind of mist with each light method
 * is compared with softpipe. A few paths may pass an edge on its other side. */
static void test_drivers(void **state) {
    (void)state;
    static const char *const lights[] = {"cosine", "mis", "control", "portal"};
    static const struct {
        const char *name, *text;
    } scenes[] = {
        {"sphere", crater_sky},         {"box", crater_colour},
        {"height, sun", crater_height}, {"sphere, sun", slits_thin},
        {"function, sun", slits_waves}, {"coloured function, sun", slits_coloured},
    };
    enum { SCENES = sizeof scenes / sizeof *scenes, LIGHTS = sizeof lights / sizeof *lights };
    double all = 0;
    drivers_need_both();
    for (int i = 0; i < SCENES * LIGHTS; i++) {
        char arguments[128];
        const char *light = lights[i % LIGHTS], *name = scenes[i / LIGHTS].name;
        snprintf(arguments, sizeof arguments, "--size 16x16 --spp %d --seed 5 --light %s",
                 (int)support_samples(64), light);
        const char *scene = support_write("drivers.glsl", scenes[i / LIGHTS].text);
        DriversDifference drivers = drivers_compare(scene, arguments);
        print_message("%s, %s: %d values differ, the others' bias %.1e\n", name, light, drivers.differ,
                      drivers.bias_of_same);
        assert_true(drivers.differ <= drivers.values / 32);
        assert_true(fabs(drivers.bias_of_same) < 1e-5);
        all += drivers.bias / (SCENES * LIGHTS);
    }
    print_message("bias of all values: %.1e\n", all);
    assert_true(fabs(all) < 1e-4);
}

/* Mist whose density the scene defines, but as the annotation could have said it: all of it, less with
 * height, and a small share of it. */
static void test_function(void **state) {
    (void)state;
    /* The stated extinction makes a depth of 24 of what has one of 0.6: no track is cut. */
#define ALBEDO " albedo 0.9 0.9 0.9 g 0.5 box 0 1.5 0 10 4 10\n"
    static const char *const pairs[][2] = {
        {CRATER("//@ sky uniform:1\n//@ mist extinction 0.3" ALBEDO, CHECKER, MATTE),
         CRATER("//@ sky uniform:1\n//@ mist extinction 0.3" ALBEDO
                "float scene_mist(vec3 p) { return 1.0; }\n",
                CHECKER, MATTE)},
        {CRATER("//@ sky uniform:1\n//@ mist extinction 0.2 falloff 2 base -2" ALBEDO, CHECKER, MATTE),
         CRATER("//@ sky uniform:1\n//@ mist extinction 0.25" ALBEDO
                "float scene_mist(vec3 p) { return 0.8 * exp(-0.5 * (p.y + 2.0)); }\n",
                CHECKER, MATTE)},
        {CRATER("//@ sky uniform:1\n//@ mist extinction 0.1" ALBEDO, CHECKER, MATTE),
         CRATER("//@ sky uniform:1\n//@ mist extinction 0.1 falloff 1e5" ALBEDO, CHECKER, MATTE)},
        {SLITS("//@ mist extinction 0.05 g 0.6 box 0 2.5 0 6 3 6\n"),
         SLITS("//@ mist extinction 2 g 0.6 box 0 2.5 0 6 3 6\n"
               "float scene_mist(vec3 p) { return 0.025; }\n")},
        {SLITS("//@ mist extinction 0.05 0.02 0.1 g 0.6 box 0 2.5 0 6 3 6\n"),
         SLITS("//@ mist extinction 1 0.4 2 g 0.6 box 0 2.5 0 6 3 6\n"
               "float scene_mist(vec3 p) { return 0.05; }\n")},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        double mean[2] = {0}, variance = 0;
        for (int k = 0; k < 2; k++) {
            static double blocks[VALUES];
            char arguments[128];
            double squares = 0;
            for (int seed = 0; seed < 4; seed++) {
                snprintf(arguments, sizeof arguments, "--size 128x128 --light cosine --seed %d --spp %d",
                         10 * k + seed, (int)support_samples(128));
                Image image = mist_render("", support_write("function.glsl", pairs[i][k]), arguments);
                double sum = 0;
                add_blocks(&image, blocks);
                image_free(&image);
                for (int v = 0; v < VALUES; v++) sum += blocks[v] / VALUES;
                mean[k] += sum / 4;
                squares += sum * sum / 4;
            }
            variance += fmax(squares - mean[k] * mean[k], 0) / 3;
        }
        double off = 100 * (mean[1] / mean[0] - 1), error = 100 * sqrt(variance) / mean[0];
        print_message("pair %zu: %+.4f %%, standard error %.4f %%\n", i, off, error);
        assert_true(fabs(off) < 0.1 + 3 * error);
        if (support_block() == 1) assert_true(fabs(off) < 0.1);
    }
}

/* relRMSE of a picture against one of many samples, percent. */
static double error_against(const Image *picture, const Image *truth) {
    double squares = 0, sum = 0;
    int values = 3 * truth->width * truth->height;
    for (int i = 0; i < truth->width * truth->height; i++) {
        for (int c = 0; c < 3; c++) {
            squares += pow((double)(picture->rgba[4 * i + c] - truth->rgba[4 * i + c]), 2) / values;
            sum += (double)truth->rgba[4 * i + c] / values;
        }
    }
    return 100 * sqrt(squares) / sum;
}

/* What is known of the sky's light in mist is a control variate: with it, the noise in the open is less, and
 * the mean is the same. A sky without a table is computed without it. */
static void test_known_sky(void **state) {
    (void)state;
    static const struct {
        const char *mist, *light;
        /* The noise of 64 samples with it, and with it over without it. */
        double most_percent, most_ratio;
    } cases[] = {
        {"extinction 0.02 g 0.6 sphere 0 0 0 8", "cosine", 5.2, 0.87},
        {"extinction 0.02 g 0.6 sphere 0 0 0 8", "control", 3.6, 0.67},
        {"extinction 0.02 g 0.6 sphere 0 0 0 8", "mis", 4.3, 0.88},
        {"extinction 0.15 g 0.6 sphere 0 0 0 8", "control", 12.5, 0.9},
        {"extinction 0.15 g -0.5 phase shanks sphere 0 0 0 8", "control", 100, 1},
        {"extinction 0.05 0.15 0.3 g 0.7 falloff 2", "mis", 100, 1.05},
        {"extinction 0.15 g 0.9 falloff 2", "cosine", 100, 1.05},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[4096], arguments[128];
        double mean = 0, difference = 0, squares = 0, noise[2];
        static const char *const skies[] = {"gauss:8", "table:gauss:8"};
        Image pictures[2], converged[2];
        snprintf(text, sizeof text,
                 CRATER("//@ sun elevation 30 azimuth 0\n//@ mist albedo 0.9 0.9 0.9 %s\n", CHECKER, MATTE),
                 cases[i].mist);
        const char *scene = support_write("known.glsl", text);
        for (int k = 0; k < 2; k++) {
            snprintf(arguments, sizeof arguments, "--size 64x64 --light %s --sky %s --seed 1 --spp %d",
                     cases[i].light, skies[k], (int)support_samples(1024));
            converged[k] = mist_render("", scene, arguments);
        }
        for (int k = 0; k < 2; k++) {
            snprintf(arguments, sizeof arguments, "--size 64x64 --light %s --sky %s --seed 2 --spp %d",
                     cases[i].light, skies[k], (int)support_samples(64));
            pictures[k] = mist_render("", scene, arguments);
            noise[k] = error_against(&pictures[k], &converged[1]);
            image_free(&pictures[k]);
        }
        for (int k = 0; k < 64 * 64; k++) {
            double d = (double)converged[1].rgba[4 * k + 1] - (double)converged[0].rgba[4 * k + 1];
            mean += (double)converged[0].rgba[4 * k + 1] / (64 * 64);
            difference += d / (64 * 64);
            squares += d * d / (64 * 64);
        }
        double error = sqrt(squares - difference * difference) / 64;
        print_message("%s, %s: noise %.2f %%, without %.2f %%; mean %+.3f %%, standard error %.3f %%\n",
                      cases[i].mist, cases[i].light, noise[1], noise[0], 100 * difference / mean,
                      100 * error / mean);
        assert_true(fabs(difference) < 1e-3 * mean + 5 * error);
        if (support_block() == 1)
            assert_true(noise[1] < cases[i].most_percent && noise[1] < cases[i].most_ratio * noise[0]);
        image_free(&converged[0]);
        image_free(&converged[1]);
    }
}

/* The error that a picture with mist is stopped at is the error that it has. */
static void test_promise(void **state) {
    (void)state;
    if (support_block() > 1) skip();
    static const char *const scenes[] = {crater_sun, slits_thin};
    for (int i = 0; i < 2; i++) {
        const char *scene = support_write("promise.glsl", scenes[i]);
        Image truth = mist_render("", scene, "--size 32x32 --spp 8192 --seed 77");
        Image picture = mist_render("", scene, "--size 32x32 --error 5 --seed 3");
        double error = error_against(&picture, &truth);
        print_message("asked for 5 %%, got %.2f %%\n", error);
        assert_true(error < 5.5 && error > 2.5);
        image_free(&truth);
        image_free(&picture);
    }
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_references), cmocka_unit_test(test_furnace), cmocka_unit_test(test_function),
        cmocka_unit_test(test_known_sky),  cmocka_unit_test(test_drivers), cmocka_unit_test(test_promise),
    };
    return cmocka_run_group_tests_name("mist_pictures", tests, support_folder, support_clean);
}
