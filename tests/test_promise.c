/* What `--error` says of a picture: a promise that is kept, or that there is none, and why. */
#include "support.h"

#include "error/promise.h"
#include "image/compare.h"
#include "image/sun_pixels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NO_AIR "--set atmosphere.rayleigh=0 --set atmosphere.mie=0"

static Image read_image(const char *path) {
    Image image;
    Error error;
    if (!image_read(&image, path, &error)) fail_msg("%s", error.text);
    return image;
}

/* The error of a picture without the pixels that it says hold the sun. */
static Comparison compare_with(const char *path, const char *truth) {
    Image a = read_image(path), b = read_image(truth);
    unsigned char *sun = calloc((size_t)a.width * (size_t)a.height, 1);
    Text text = {0};
    Comparison result;
    Error error;
    assert_non_null(sun);
    if (support_attribute(path, SUN_PIXELS_ATTRIBUTE, &text))
        assert_true(sun_pixels_parse(text_string(&text), sun, a.width, a.height, &error));
    CompareOptions options = {.sun = sun};
    if (!compare_images(&a, &b, &options, &result, &error)) fail_msg("%s", error.text);
    free(sun);
    text_free(&text);
    image_free(&a);
    image_free(&b);
    return result;
}

/* Sunlight by way of a glass ball, which only chance finds. Before the classes of paths were counted, one
 * seed in ten stopped after 16 samples at a true error of 31 %. */
static void test_glass(void **state) {
    (void)state;
    const char *out = support_path("glass.exr");
    int given = 0;
    for (int seed = 11; seed < 15; seed++) {
        Text promised = {0}, samples = {0};
        int status = support_run(
            "", "render tests/data/glass.glsl --size 32x32 " NO_AIR " --error 10 --seed %d -o '%s'", seed,
            out);
        assert_true(support_attribute(out, "magichour.promised", &promised));
        assert_true(support_attribute(out, "magichour.samples", &samples));
        double percent = compare_with(out, "tests/data/glass.exr").rel_rmse_percent;
        print_message("seed %d: %.3g %% true after %s samples, promised: %s\n", seed, percent,
                      text_string(&samples), text_string(&promised));
        assert_true(atof(text_string(&samples)) >= 1024);
        bool kept = strcmp(text_string(&promised), "true") == 0;
        assert_int_equal(status, kept ? 0 : STATUS_UNPROMISED);
        if (kept) {
            given++;
            assert_true(percent < 1.1 * 10);
        }
        text_free(&promised);
        text_free(&samples);
    }
    assert_true(given > 0);
}

/* A mirror that the scene does not name beside one that it names: its light is so rare that no error is
 * promised, and the material is said. Before, 1.8 % was claimed in silence where 390 % was true. */
static void test_unnamed_mirror(void **state) {
    (void)state;
    const char *scene = support_write(
        "mirrors.glsl", "//@ camera eye 0 2 -5 target 0 0.8 0 fov 60\n//@ sun elevation 30 azimuth 90\n"
                        "//@ mirror-sphere -1.5 0.5 0 0.5\n"
                        "#include \"material/matte.glsl\"\n#include \"material/mirror.glsl\"\n"
                        "#include \"shape/box.glsl\"\n#include \"shape/plane.glsl\"\n"
                        "#include \"shape/sphere.glsl\"\n"
                        "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                        "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n"
                        "    hit_sphere(ray, vec3(-1.5, 0.5, 0.0), 0.5, 1, hit);\n"
                        "    hit_box(ray, vec3(-2.5, 6.0, 0.0), vec3(0.02, 6.0, 8.0), 2, hit);\n}\n"
                        "Material scene_material(Hit hit) {\n"
                        "    if (hit.object == 1) return mirror(vec3(0.9));\n"
                        "    if (hit.object == 2 && abs(hit.normal.x) > 0.5) return mirror(vec3(0.95));\n"
                        "    return matte(vec3(0.5));\n}\n");
    assert_int_equal(support_run("", "render '%s' --sun-disk --size 24x24 --error 5 --progress json -o '%s'",
                                 scene, support_path("mirrors.exr")),
                     STATUS_UNPROMISED);
    assert_non_null(strstr(support_err, "an error of 5 % is not promised: it would take more than 2^20"));
    assert_non_null(strstr(support_err, "sunlight that is thrown by mirrors"));
    assert_non_null(strstr(support_err, "\"promised\": false"));
    assert_non_null(strstr(support_err, "\"unpromised_reason\": \""));
    /* Few samples have met too little of the light to know its noise. */
    support_expect(STATUS_UNPROMISED, "sunlight that is thrown by mirrors",
                   "render '%s' --sun-disk --size 24x24 --error 5 --time 0.05 -o '%s'", scene,
                   support_path("mirrors.exr"));
}

static const char *box_scene(const char *name, const char *material) {
    char text[1024];
    snprintf(text, sizeof text,
             "//@ camera eye 0 1 -3 target 0 1 0 fov 60\n//@ sun elevation 40 azimuth 60\n"
             "#include \"material/matte.glsl\"\n#include \"material/emitter.glsl\"\n"
             "#include \"shape/box.glsl\"\n#include \"shape/sphere.glsl\"\n"
             "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
             "    hit_box(ray, vec3(0.0, 1.0, 0.0), vec3(5.0, 5.0, 5.0), 0, hit);\n"
             "    hit_sphere(ray, vec3(0.0, 4.0, 0.0), 0.5, 1, hit);\n}\n"
             "Material scene_material(Hit hit) { return hit.object == 1 ? %s : matte(vec3(0.7)); }\n",
             material);
    return support_write(name, text);
}

/* Pictures of nothing end, and sums that overflow are told and are no NaN. */
static void test_ends(void **state) {
    (void)state;
    const char *out = support_path("ends.pfm");
    support_expect(STATUS_UNPROMISED, "is not promised: no path has found any light",
                   "render '%s' --size 16x16 --error 5 -o '%s'", box_scene("closed.glsl", "matte(vec3(0.1))"),
                   out);
    support_expect(STATUS_UNPROMISED, "is not promised: ", "render '%s' --size 16x16 --error 1e-3 -o '%s'",
                   box_scene("faint.glsl", "emitter(vec3(1e-20))"), out);
    support_run("", "render '%s' --size 16x16 --error 5 -o '%s'",
                box_scene("bright.glsl", "emitter(vec3(3e37))"), out);
    assert_non_null(strstr(support_err, "too large to be summed"));
}

static void expect_finite(const char *path) {
    Image image = read_image(path);
    for (int i = 0; i < 4 * image.width * image.height; i++) assert_true(isfinite(image.rgba[i]));
    image_free(&image);
}

/* 1e30 can be summed, 1e36 not everywhere, and more nowhere. */
static void expect_said(size_t radiance, const char *words) {
    bool said = strstr(support_err, words) != NULL;
    if (radiance != 1) assert_true(said == (radiance > 1));
}

/* A lamp of any radiance that a float holds makes pictures of finite numbers, that end, and that say what was
 * left out. */
static void test_overflow(void **state) {
    static const char *const radiances[] = {"1e30", "1e36", "3e37", "1e38", "3.4e38"};
    (void)state;
    const char *out = support_path("overflow.pfm");
    for (size_t i = 0; i < sizeof radiances / sizeof *radiances; i++) {
        char material[64];
        snprintf(material, sizeof material, "emitter(vec3(%s))", radiances[i]);
        const char *scene = box_scene("overflow.glsl", material);
        support_run("", "render '%s' --size 16x16 --error 5 -o '%s'", scene, out);
        expect_finite(out);
        expect_said(i, "samples were not finite, or too large to be summed");
        if (i) assert_non_null(strstr(support_err, "an error of 5 % is not promised: "));
        support_run("", "render '%s' --size 16x16 --spp 16 --sequence metropolis -o '%s'", scene, out);
        expect_finite(out);
        expect_said(i, "points of light were not finite, or too large");
        support_run("", "render '%s' --size 16x16 --error 200levels -o '%s'", scene, out);
        expect_finite(out);
    }
}

/* Closed boxes in which light is never lost, with a speck of light in two of them: next to nothing comes out,
 * and yet their pictures end. Light that is faint everywhere is as good as any. */
static void test_closed(void **state) {
    static const char *const materials[] = {"mirror(vec3(1.0))", "matte(vec3(1.0))", "emitter(vec3(1e-6))"};
    (void)state;
    const char *out = support_path("closed.pfm");
    for (int i = 0; i < 5; i++) {
        char text[1024];
        snprintf(
            text, sizeof text,
            "//@ camera eye 0 1 -3 target 0 1 0 fov 60\n"
            "#include \"material/matte.glsl\"\n#include \"material/mirror.glsl\"\n"
            "#include \"material/emitter.glsl\"\n#include \"shape/box.glsl\"\n"
            "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
            "    hit_box(ray, vec3(0.0, 1.0, 0.0), vec3(5.0), 0, hit);\n}\n"
            "Material scene_material(Hit hit) {\n"
            "    if (%s && hit.position.x > 4.9 && length(vec2(hit.position.y, hit.position.z)) < 0.05)\n"
            "        return emitter(vec3(0.1));\n    return %s;\n}\n",
            i % 4 < 2 ? "false" : "true", materials[i < 4 ? i % 2 : 2]);
        /* A few paths in 100,000 get out of a box by its edges, where they may find the sky. */
        bool even = i == 4;
        support_expect(even ? 0 : STATUS_UNPROMISED,
                       even ? "" : "is not promised: ", "render '%s' --size 16x16 --error 1 -o '%s'",
                       support_write("closed.glsl", text), out);
        bool black = strstr(support_err, "no path has found any light") != NULL;
        assert_true(even || black || strstr(support_err, "it would take more than 2^20"));
        Image image = read_image(out);
        double sum = 0;
        for (int k = 0; k < 4 * image.width * image.height; k++) sum += k % 4 < 3 ? (double)image.rgba[k] : 0;
        print_message("mean %.3g\n", sum / 3 / image.width / image.height);
        assert_true(black == (sum <= 0));
        image_free(&image);
    }
}

/* The sun's own image is in neither the error nor the mean, and the file says where it is. */
static void test_sun_in_view(void **state) {
    (void)state;
    const char *truth = support_path("truth.exr"), *out = support_path("view.exr");
    Text sun = {0};
    const char *scene = support_write(
        "view.glsl", "//@ camera eye 0 1.5 -5 target 0 2.5 0 fov 60\n//@ sun elevation 12 azimuth 0\n"
                     "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"
                     "#include \"shape/sphere.glsl\"\n"
                     "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                     "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n"
                     "    hit_sphere(ray, vec3(-1.5, 1.0, 0.0), 1.0, 1, hit);\n}\n"
                     "Material scene_material(Hit hit) { return matte(vec3(0.5)); }\n");
    support_expect(0, "", "render '%s' --sun-disk --size 48x32 --spp 4096 --seed 9 -o '%s'", scene, truth);
    support_expect(0, "", "render '%s' --sun-disk --size 48x32 --error 2 -o '%s'", scene, out);
    assert_true(support_attribute(out, SUN_PIXELS_ATTRIBUTE, &sun) && *text_string(&sun));
    Comparison result = compare_with(out, truth);
    print_message("%ld pixels of the sun; %.3g %% true\n", result.sun_pixels, result.rel_rmse_percent);
    assert_true(result.sun_pixels > 0 && result.sun_pixels < 12 && result.rel_rmse_percent < 2);
    text_free(&sun);
}

/* A promise in levels holds for the picture and for each tile of it. */
static void test_levels(void **state) {
    (void)state;
    const char *truth = support_path("truth.exr"), *out = support_path("levels.exr");
    support_expect(0, "", "render scenes/crater.glsl --size 64x64 --spp 4096 --seed 9 --sun 5 -o '%s'",
                   truth);
    support_expect(0, "", "render scenes/crater.glsl --size 64x64 --error 2levels --sun 5 -o '%s'", out);
    Comparison result = compare_with(out, truth);
    print_message("%.3g levels, worst tile %.3g\n", result.levels.rms, result.levels.worst_tile);
    assert_true(result.levels.rms < 2 && result.levels.rms > 0.5 && result.levels.worst_tile < 4.4);
    assert_non_null(strstr(support_out, "levels"));
}

static void test_words(void **state) {
    (void)state;
    const char *out = support_path("words.pfm");
    support_expect(STATUS_UNPROMISED, "an error of 0.01 % is not promised: the time was up",
                   "render scenes/crater.glsl --size 64x64 --sky gauss:12 --error 0.01 --time 0.1 -o '%s'",
                   out);
    support_expect(STATUS_UNPROMISED, "not promised: the sky alone may err by more",
                   "render scenes/crater.glsl --size 16x16 --sky paper:16x4 --error 1 -o '%s'", out);
    support_expect(STATUS_USAGE, "--error", "render scenes/crater.glsl --error 2level -o '%s'", out);
    support_expect(STATUS_USAGE, "--error", "render scenes/crater.glsl --error levels -o '%s'", out);
    /* Nothing was asked for, so nothing is refused. */
    support_expect(0, "", "render scenes/crater.glsl --size 16x16 --spp 1 --progress json -o '%s'", out);
    assert_null(strstr(support_err, "promised"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_glass),    cmocka_unit_test(test_unnamed_mirror),
        cmocka_unit_test(test_ends),     cmocka_unit_test(test_sun_in_view),
        cmocka_unit_test(test_overflow), cmocka_unit_test(test_closed),
        cmocka_unit_test(test_levels),   cmocka_unit_test(test_words),
    };
    return cmocka_run_group_tests_name("promise", tests, support_folder, support_clean);
}
