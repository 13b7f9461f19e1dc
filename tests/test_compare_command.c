/* `compare` as it is used: pictures of other programs, what it prints, and what it writes. */
#include "exr_files.h"
#include "support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define TINY "--size 16x16 --spp 1 --sky uniform"

/* A picture of that size, of one value but for one pixel's red. */
static const char *write_picture(const char *name, int width, int height, float value, float red, int pixel) {
    Error error;
    const char *path = support_path(name);
    Image image = image_create(width, height);
    for (int i = 0; i < 4 * width * height; i++) image.rgba[i] = value;
    image.rgba[4 * pixel] = red;
    if (!image_write(&image, path, &(ImageWriteParams){.tone = TONE_NONE}, &error))
        fail_msg("%s", error.text);
    image_free(&image);
    return path;
}

static void expect_line(const char *line) {
    if (!strstr(support_out, line)) fail_msg("'%s' lacks '%s'", support_out, line);
}

static void test_command_layers(void **state) {
    (void)state;
    const char *many = support_path("many.exr"), *one = support_path("one.exr");
    exr_file_write(many, &(ExrFile){.parts = {{"albedo", "R G B"}, {"beauty", "R G B"}}});
    exr_file_write(one, &(ExrFile){.parts = {{NULL, "R G B"}}});
    support_expect(0, "", "compare '%s' '%s' --layer albedo --layer '' --max-relrmse 0", many, one);
    expect_line("read A       layer 'albedo' of 2\nrelRMSE");
    support_expect(0, "", "compare '%s' '%s' --layer '' --layer albedo --max-relrmse 0", one, many);
    expect_line("read B       layer 'albedo' of 2\nrelRMSE");
    support_expect(0, "", "compare '%s' '%s' --layer albedo --max-relrmse 0", many, many);
    support_expect(6, "differs from", "compare '%s' '%s' --max-relrmse 1", many, one);
    support_expect(1, "one.exr: no layer 'albedo'; its layers: '' (R, G, B)",
                   "compare '%s' '%s' --layer albedo", many, one);
    support_expect(2, "--layer more than 2 times", "compare '%s' '%s' --layer a --layer b --layer c", many,
                   one);
}

static void test_command_outside(void **state) {
    (void)state;
    const char *part = support_path("part.exr"), *all = support_path("all.exr");
    exr_file_write(part,
                   &(ExrFile){.parts = {{NULL, "R G B"}}, .data = {2, 3, 4, 5}, .display = {0, 0, 10, 9}});
    exr_file_write(all,
                   &(ExrFile){.parts = {{NULL, "R G B"}}, .data = {0, 0, 10, 9}, .display = {0, 0, 10, 9}});
    support_expect(0, "", "compare '%s' '%s' --max-relrmse 0", part, all);
    expect_line("read A       display window of 10x9, data window of 4x5 at 2,3 in it\n");
    expect_line("pixels       20, 0 not finite\noutside      70 left out");
}

static void test_command_nonfinite(void **state) {
    (void)state;
    const char *a = write_picture("nan.pfm", 7, 5, 1, NAN, 2 * 7 + 3),
               *b = write_picture("1.pfm", 7, 5, 1, 1, 0);
    support_expect(0, "", "compare '%s' '%s'", a, b);
    expect_line("pixels       35, 1 not finite, the first at 3,2\n");
    support_expect(6, "1 pixels are not finite, the first at 3,2", "compare '%s' '%s' --max-relrmse 5", a, b);
}

/* A PNG is compared as it is shown. Dithering rounds a level up as often as its fraction f says, which is an
 * error of the variance f (1 - f), and 1/6 in the mean over all fractions. */
static void test_command_png(void **state) {
    (void)state;
    Error error;
    AttributeList list = {0};
    const char *png = support_path("shown.png"), *exr = support_path("shown.exr");
    Image image = image_create(100, 100);
    for (int i = 0; i < 40000; i++) image.rgba[i] = 0.2F + 0.3F * (float)(i % 10007) / 10007;
    attribute_add(&list, "magichour.exposure", "-1");
    assert_true(
        image_write(&image, png, &(ImageWriteParams){.exposure_ev = -1, .attributes = &list}, &error));
    assert_true(image_write(&image, exr, &(ImageWriteParams){0}, &error));
    attribute_list_free(&list);
    image_free(&image);
    static const char *const orders[] = {"compare '%s' '%s' --max-levels 0.43",
                                         "compare '%s' '%s' --max-levels 0.38"};
    for (int turn = 0; turn < 2; turn++) {
        const char *a = turn ? exr : png, *b = turn ? png : exr;
        support_expect(0, "", orders[0], a, b);
        support_expect(6, "differs from", orders[1], a, b);
        expect_line(turn ? "read B       PNG of 8 bits, tone-mapped: compared as it is shown, in levels "
                           "only\nlevels RMS"
                         : "read A       PNG of 8 bits, tone-mapped: compared as it is shown, in levels "
                           "only\nlevels RMS");
        assert_null(strstr(support_out, "relRMSE"));
        support_expect(6, "differs from", "compare '%s' '%s' --exposure 0 --max-levels 5", a, b);
        support_expect(2, "shown.png: a PNG holds no radiance", "compare '%s' '%s' --max-relrmse 1", a, b);
        support_expect(2, "shown.png: a PNG holds no radiance", "compare '%s' '%s' --max-bias 1", a, b);
        support_expect(2, "shown.png: a PNG holds no radiance", "compare '%s' '%s' --se '%s'", a, b, exr);
    }
    support_expect(0, "", "compare '%s' '%s' --max-levels 0", png, png);
    expect_line("read B       PNG");
}

static void test_command_json(void **state) {
    (void)state;
    const char *a = write_picture("a.pfm", 7, 5, 1, 2, 0), *b = write_picture("b.pfm", 7, 5, 1, 1, 0);
    support_expect(0, "", "compare '%s' '%s' --json --tone none", a, b);
    assert_string_equal(support_out,
                        "{\"relRMSE\": 9.75900073, \"trimmed\": 0, \"bias_R_G_B\": [2.85714286, 0, 0], "
                        "\"largest\": 100, \"p99\": 0, \"levels_RMS\": 0, \"worst_tile\": 0, "
                        "\"worst_tile_at\": [0, 0], \"pixels\": 35, \"not_finite\": 0, \"outside\": 0, "
                        "\"sun_pixels\": 0, \"within\": true}\n");
    const char *nan = write_picture("nan.pfm", 7, 5, 1, NAN, 3 * 7 + 2);
    support_expect(6, "not finite", "compare '%s' '%s' --json --max-relrmse 1000 --se '%s'", nan, b, b);
    expect_line("\"not_finite\": 1, \"not_finite_at\": [2, 3]");
    expect_line("\"mean_z2\": 0, \"share_z4\": 0, \"within\": false}\n");
    const char *zero = write_picture("zero.pfm", 7, 5, 0, 0, 0);
    support_expect(0, "", "compare '%s' '%s' --json", b, zero);
    expect_line("\"relRMSE\": null");
}

static void test_command_quiet(void **state) {
    (void)state;
    const char *a = write_picture("a.pfm", 7, 5, 1, 2, 0), *b = write_picture("b.pfm", 7, 5, 1, 1, 0);
    support_expect(0, "", "compare '%s' '%s' --quiet --max-relrmse 10", a, b);
    assert_string_equal(support_out, "");
    assert_int_equal(support_run("", "compare '%s' '%s' --quiet --max-relrmse 9", a, b), 6);
    assert_string_equal(support_out, "");
    assert_string_equal(support_err, "");
    support_expect(2, "--quiet prints nothing, --json prints a line", "compare '%s' '%s' --quiet --json", a,
                   b);
    support_expect(1, "none.pfm", "compare '%s' '%s' --quiet", a, support_path("none.pfm"));
}

/* The pictures that are written are read again, by the program's own reader. */
static void test_command_pictures(void **state) {
    (void)state;
    Error error;
    Image difference, sheet;
    const char *a = write_picture("a.pfm", 80, 70, 0, 1, 3 * 80 + 5),
               *b = write_picture("b.pfm", 80, 70, 0, 0, 0);
    const char *diff = support_path("diff.png"), *side = support_path("side.png");
    support_expect(0, "", "compare '%s' '%s' -o '%s' --side-by-side '%s' --tone none", a, b, diff, side);
    expect_line("relRMSE");
    assert_true(image_read(&difference, diff, &error));
    assert_true(image_read(&sheet, side, &error));
    assert_int_equal(difference.height, sheet.height);
    assert_int_equal(sheet.width - difference.width, 2 * (80 + 8));
    /* The pixel is red in the difference, and in the panel of A, where it lies as far from the panel's
     * corner. */
    const float *red = difference.rgba + 4 * ((26 + 3) * difference.width + 8 + 5);
    assert_true(red[0] > 0.4F && red[1] < 0.01F && red[2] < 0.05F);
    red = sheet.rgba + 4 * ((26 + 3) * sheet.width + 8 + 5);
    assert_true(red[0] == 1 && red[1] == 0 && red[2] == 0);
    assert_true(red[4] == 0);
    const float *panel_b = red + 4 * (80 + 8L), *panel_difference = panel_b + 4 * (80 + 8L);
    assert_true(panel_b[0] == 0 && panel_b[1] == 0);
    assert_true(panel_difference[0] > 0.4F && panel_difference[1] < 0.01F);
    image_free(&difference);
    image_free(&sheet);
    support_expect(2, "diff.exr: false colours can only be written as .png", "compare '%s' '%s' -o diff.exr",
                   a, b);
    support_expect(2, "diff: false colours can only", "compare '%s' '%s' --side-by-side diff", a, b);
    support_expect(5, "none/a.png", "compare '%s' '%s' -o '%s/none/a.png'", a, b, support_path("x"));
}

static void test_compare(void **state) {
    (void)state;
    const char *a = support_path("a.exr"), *b = support_path("b.pfm"), *c = support_path("c.pfm");
    support_expect(0, "", "render scenes/crater.glsl " TINY " --quiet -o '%s' -o '%s'", a, b);
    support_expect(0, "", "render scenes/crater.glsl " TINY " --seed 1 --quiet -o '%s'", c);
    support_expect(0, "", "compare '%s' '%s' --max-relrmse 0 --max-bias 0", a, b);
    assert_non_null(strstr(support_out, "relRMSE      0.0000 %"));
    support_expect(6, "differs from", "compare '%s' '%s' --max-relrmse 0.001", a, c);
    support_expect(0, "", "compare '%s' '%s' --max-relrmse 1000", a, c);
    support_expect(0, "", "render scenes/crater.glsl --size 8x8 --spp 1 --sky uniform --quiet -o '%s'", c);
    support_expect(2, "16x16", "compare '%s' '%s'", a, c);
}

/* A grey picture with a sun of 1e5 in some pixels, and metadata that name the sun's pixels. */
static void write_sun(const char *path, float grey, const char *pixels, const char *exposure) {
    Error error;
    AttributeList list = {0};
    Image image = image_create(20, 20);
    for (int i = 0; i < 4 * 400; i++) image.rgba[i] = i / 80 == 3 && i / 4 % 20 < 5 ? 1e5F * grey : grey;
    if (pixels) attribute_add(&list, "magichour.sun_pixels", "%s", pixels);
    if (exposure) attribute_add(&list, "magichour.exposure", "%s", exposure);
    assert_true(image_write(&image, path, &(ImageWriteParams){.attributes = &list}, &error));
    attribute_list_free(&list);
    image_free(&image);
}

/* The pixels of the sun's image in either file are left out; the levels have the reference's exposure. */
static void test_compare_shown(void **state) {
    (void)state;
    const char *a = support_path("shown.exr"), *b = support_path("shown2.exr"),
               *bad = support_path("bad.exr");
    write_sun(a, 0.11F, "0,3,3,1", NULL);
    write_sun(b, 0.1F, "2,3,3,1", "1");
    support_expect(0, "", "compare '%s' '%s' --max-relrmse 10.001", a, b);
    assert_non_null(strstr(support_out, "sun pixels   5 left out"));
    assert_non_null(strstr(support_out, "pixels       395, 0 not finite"));
    double level = tone_level(TONE_AUTHOR, 2, (double)0.11F) - tone_level(TONE_AUTHOR, 2, (double)0.1F);
    char line[64];
    snprintf(line, sizeof line, "levels RMS   %.4f of 255", level);
    assert_non_null(strstr(support_out, line));
    support_expect(0, "", "compare '%s' '%s' --max-levels %g", a, b, level + 0.001);
    support_expect(6, "differs from", "compare '%s' '%s' --max-levels %g", a, b, level - 0.001);
    support_expect(6, "differs from", "compare '%s' '%s' --with-sun --max-relrmse 10.001", a, b);
    assert_non_null(strstr(support_out, "sun pixels   0 left out"));
    support_expect(0, "", "compare '%s' '%s' --exposure -2 --tone none", a, b);
    level = tone_level(TONE_NONE, 0.25, (double)0.11F) - tone_level(TONE_NONE, 0.25, (double)0.1F);
    snprintf(line, sizeof line, "levels RMS   %.4f of 255", level);
    assert_non_null(strstr(support_out, line));
    write_sun(bad, 0.1F, "0,3,50,1", NULL);
    support_expect(1, "bad.exr: sun pixels: '0,3,50,1' is not inside", "compare '%s' '%s'", a, bad);
    support_expect(0, "", "compare '%s' '%s' --with-sun", a, bad);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_command_layers),    cmocka_unit_test(test_command_outside),
        cmocka_unit_test(test_command_nonfinite), cmocka_unit_test(test_command_png),
        cmocka_unit_test(test_command_json),      cmocka_unit_test(test_command_quiet),
        cmocka_unit_test(test_command_pictures),  cmocka_unit_test(test_compare),
        cmocka_unit_test(test_compare_shown),
    };
    return cmocka_run_group_tests_name("compare_command", tests, support_folder, support_clean);
}
