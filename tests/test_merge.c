/* Parts of a picture become one, to the bit what one run makes. */
#include "support.h"

#include "base/memory.h"
#include "image/format.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PARTS = 8 };

static Image read_image(const char *path, const char *layer) {
    Image image;
    Error error;
    ImageReadParams params = {.layer = layer};
    if (!image_read_as(&image, path, &params, &error)) fail_msg("%s", error.text);
    return image;
}

static size_t values_of(const Image *image) {
    return 4 * (size_t)image->width * (size_t)image->height;
}

static void expect_same(const char *a, const char *b, const char *layer) {
    Image x = read_image(a, layer), y = read_image(b, layer);
    assert_int_equal(values_of(&x), values_of(&y));
    assert_memory_equal(x.rgba, y.rgba, values_of(&x) * sizeof *x.rgba);
    image_free(&x);
    image_free(&y);
}

/* Relative to the mean. */
static void expect_near(const char *a, const char *b, const char *layer, double most) {
    Image x = read_image(a, layer), y = read_image(b, layer);
    double square = 0, mean = 0;
    for (size_t i = 0; i < values_of(&x); i++) {
        square += pow((double)x.rgba[i] - (double)y.rgba[i], 2);
        mean += fabs((double)x.rgba[i]);
    }
    double values = (double)values_of(&x);
    assert_true(sqrt(square / values) <= most * mean / values);
    image_free(&x);
    image_free(&y);
}

static void expect_same_figure(const char *a, const char *b, const char *name) {
    Text x = {0}, y = {0};
    assert_true(support_attribute(a, name, &x) == support_attribute(b, name, &y));
    assert_string_equal(text_string(&x), text_string(&y));
    text_free(&x);
    text_free(&y);
}

static const char *part_path(int i) {
    char name[32];
    snprintf(name, sizeof name, "part%d.exr", i);
    return support_path(name);
}

/* Renders eight parts of `samples` samples, and all of them in one run. */
static void render_parts(const char *options, int samples) {
    for (int i = 0; i < PARTS; i++) {
        if (support_run("", "render %s --first-sample %d --spp %d --of %d -o '%s' --quiet", options,
                        i * samples, samples, PARTS * samples, part_path(i)))
            fail_msg("%s", support_err);
    }
    if (support_run("", "render %s --spp %d -o '%s' --quiet", options, PARTS * samples,
                    support_path("one.exr")))
        fail_msg("%s", support_err);
}

/* Merges the parts in the order of `order`, eight digits. */
static void merge_parts(const char *order, const char *out, const char *options) {
    Text line = {0};
    text_print(&line, "merge -o '%s' %s", out, options);
    for (int i = 0; order[i]; i++) text_print(&line, " '%s'", part_path(order[i] - '0'));
    if (support_run("", "%s", text_string(&line))) fail_msg("%s", support_err);
    text_free(&line);
}

/* A scene of each kind: matte, with steps, with light paths and chance, with mist and lamps. */
static void test_ranges(void **state) {
    (void)state;
    static const char *const scenes[] = {
        "scenes/crater.glsl --size 64x48 --aov albedo,depth,samples", "scenes/valley.glsl --size 32x24",
        "scenes/materials.glsl --size 32x24 --sun-disk",
        "scenes/box-room.glsl --preset smoke --size 32x32 --sequence random"};
    const char *one = support_path("one.exr"), *all = support_path("all.exr");
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        render_parts(scenes[i], 16);
        merge_parts("52701364", all, "");
        expect_same(one, all, NULL);
        static const char *const figures[] = {"magichour.error_percent", "magichour.samples",
                                              "magichour.samples_range", "magichour.rejected",
                                              "magichour.searches",      "magichour.light_paths",
                                              "magichour.sun_pixels",    "magichour.chance_light_percent"};
        for (size_t k = 0; k < sizeof figures / sizeof *figures; k++)
            expect_same_figure(one, all, figures[k]);
        for (int k = 0; i == 0 && k < 3; k++) {
            static const char *const layers[] = {"albedo", "Z", "samples"};
            expect_near(one, all, layers[k], 1e-6);
        }
        /* In another order, and of parts that are merged already. */
        merge_parts("0123", support_path("half.exr"), "");
        merge_parts("7564", support_path("rest.exr"), "");
        support_expect(0, "", "merge '%s' '%s' -o '%s' --final", support_path("rest.exr"),
                       support_path("half.exr"), all);
        expect_same(one, all, NULL);
        support_expect(1, "cannot be merged", "merge '%s' -o '%s'", all, support_path("again.exr"));
    }
}

/* The variance of the merged picture is that of one run, but for rounding. */
static void test_variance(void **state) {
    (void)state;
    render_parts("scenes/crater.glsl --size 48x48 --aov variance --sequence random", 32);
    merge_parts("76543210", support_path("all.exr"), "");
    expect_same(support_path("one.exr"), support_path("all.exr"), NULL);
    expect_near(support_path("one.exr"), support_path("all.exr"), "variance", 1e-4);
}

/* Crops tile a picture, also crops of parts of the samples, and with light paths. */
static void test_crops(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/crater.glsl --size 60x40",
                                         "scenes/materials.glsl --size 60x40 "
                                         "--sun-disk=traced"};
    static const char *const crops[] = {"0,0,25,40", "25,0,35,17", "25,17,35,23"};
    const char *one = support_path("one.exr"), *all = support_path("all.exr");
    for (int s = 0; s < 2; s++) {
        if (support_run("", "render %s --spp 32 -o '%s' --quiet", scenes[s], one))
            fail_msg("%s", support_err);
        for (int i = 0; i < 6; i++) {
            if (support_run("", "render %s --crop %s --first-sample %d --of 32 --spp 16 -o '%s' --quiet",
                            scenes[s], crops[i % 3], i / 3 * 16, part_path(i)))
                fail_msg("%s", support_err);
        }
        merge_parts("012345", all, "");
        expect_same(one, all, NULL);
        /* A part of the pixels is a part of the picture, and says so. */
        merge_parts("03", all, "");
        Image part = read_image(all, NULL), whole = read_image(one, NULL);
        assert_true(part.data.width == 25 && part.data.height == 40);
        for (int y = 0; y < 40; y++)
            assert_memory_equal(part.rgba + 240 * y, whole.rgba + 240 * y, 25 * 4 * sizeof(float));
        image_free(&part);
        image_free(&whole);
    }
    /* A PNG has the crop alone. */
    support_expect(0, "", "render %s --crop 10,5,20,30 --spp 16 -o '%s' --quiet", scenes[0],
                   support_path("crop.png"));
    Image crop = read_image(support_path("crop.png"), NULL);
    assert_true(crop.width == 20 && crop.height == 30);
    image_free(&crop);
}

static void test_refusals(void **state) {
    (void)state;
    const char *a = part_path(0), *b = part_path(1), *out = support_path("out.exr");
#define PART "render scenes/crater.glsl --size 32x32 --quiet -o '%s' "
    support_expect(0, "", PART "--first-sample 0 --spp 32", a);
    support_expect(0, "", PART "--first-sample 16 --spp 32", b);
    support_expect(1, "both have samples 16 to 31", "merge '%s' '%s' -o '%s'", a, b, out);
    support_expect(1, "both have samples 0 to 31", "merge '%s' '%s' -o '%s'", a, a, out);
    support_expect(0, "", PART "--first-sample 32 --spp 32 --seed 1", b);
    support_expect(1, "seed was 0, and is 1 now", "merge '%s' '%s' -o '%s'", a, b, out);
    support_expect(0, "", PART "--first-sample 32 --spp 32 --set camera.fov=80", b);
    support_expect(1, "camera.fov was ", "merge '%s' '%s' -o '%s'", a, b, out);
    support_expect(0, "", PART "--spp 32", b);
    support_expect(1, "holds no sums", "merge '%s' '%s' -o '%s'", a, b, out);
    support_expect(1, "cannot be read", "merge '%s' '%s' -o '%s'", a, support_path("none.exr"), out);
    support_expect(2, "where to?", "merge '%s'", a);
    support_expect(2, "the picture has 32x32 pixels", PART "--crop 8,8,25,4", out);
    support_expect(2, "is not X,Y,WIDTH,HEIGHT", PART "--crop 8,8,25", out);
    support_expect(2, "at least 1x1", PART "--crop 8,8,0,1", out);
    support_expect(2, "may not go past sample 4294967295", PART "--first-sample 4294967290 --spp 16", out);
    support_expect(2, "--of 16: the part ends with sample 31", PART "--first-sample 16 --spp 16 --of 16",
                   out);
    support_expect(2, "paths have no numbers", PART "--first-sample 16 --spp 16 --sequence metropolis", out);
}

/* Samples past the 32 bits of their numbers are new ones, of the same picture. */
static void test_laps(void **state) {
    (void)state;
    static const unsigned long long firsts[] = {0, 4294967296ULL - 1024, 4294967296ULL, 3 * 4294967296ULL};
    double means[4];
    for (int i = 0; i < 4; i++) {
        support_expect(0, "",
                       "render scenes/crater.glsl --size 32x32 --quiet --first-sample %llu --spp 1024 "
                       "--sky uniform:1 -o '%s'",
                       firsts[i], part_path(i));
        Image image = read_image(part_path(i), NULL);
        means[i] = 0;
        for (size_t k = 0; k < values_of(&image); k++) means[i] += (double)image.rgba[k];
        image_free(&image);
        for (int k = 0; k < i; k++) {
            assert_true(means[k] != means[i]);
            assert_true(fabs(means[k] / means[i] - 1) < 1e-3);
        }
    }
    support_expect(0, "", "merge '%s' '%s' '%s' '%s' -o '%s'", part_path(0), part_path(1), part_path(2),
                   part_path(3), support_path("all.exr"));
    assert_non_null(strstr(support_out, "4 parts, 4096 samples"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ranges),   cmocka_unit_test(test_variance), cmocka_unit_test(test_crops),
        cmocka_unit_test(test_refusals), cmocka_unit_test(test_laps),
    };
    return cmocka_run_group_tests_name("merge", tests, support_folder, support_clean);
}
