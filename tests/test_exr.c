/* EXR files of other programs: which of their layers is the picture, where its pixels lie, and how they were
 * compressed. */
#include "exr_files.h"
#include "support.h"

#include "base/file.h"
#include "base/memory.h"
#include "image/codec.h"
#include "image/compare.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *file_of(const ExrFile *file) {
    const char *path = support_path("a.exr");
    exr_file_write(path, file);
    return path;
}

/* The file's first pixel is that colour, and the reader says that of it. */
static void expect_pixel(const char *path, const char *layer, const float rgba[4], const char *says) {
    Error error;
    Image image;
    Text said = {0};
    if (!image_read_as(&image, path, &(ImageReadParams){.layer = layer, .said = &said}, &error))
        fail_msg("%s", error.text);
    assert_int_equal(image.width, 4);
    assert_int_equal(image.height, 3);
    for (int i = 0; i < 4 * 12; i++) {
        if (!(fabsf(image.rgba[i] - rgba[i % 4]) <= 1e-4F * fabsf(rgba[i % 4])))
            fail_msg("%s: value %d is %g instead of %g", path, i, (double)image.rgba[i], (double)rgba[i % 4]);
    }
    assert_string_equal(text_string(&said), says);
    text_free(&said);
    image_free(&image);
}

static void expect_refused(const char *path, const char *layer, const char *reason) {
    Error error;
    Image image;
    assert_false(image_read_as(&image, path, &(ImageReadParams){.layer = layer}, &error));
    assert_int_equal(error.status, STATUS_FAILURE);
    assert_ptr_equal(strstr(error.text, path), error.text);
    if (!strstr(error.text, reason)) fail_msg("'%s' lacks '%s'", error.text, reason);
    assert_null(image.rgba);
}

/* The rule by which the picture is found. */
static void test_exr_picture(void **state) {
    (void)state;
    const struct {
        ExrFile file;
        float rgba[4];
        const char *says;
    } cases[] = {
        {{.parts = {{NULL, "A B G R"}}}, {4, 3, 2, 1}, ""},
        {{.parts = {{NULL, "B G R Z albedo.R albedo.G albedo.B"}}}, {3, 2, 1, 1}, ""},
        {{.parts = {{"albedo", "albedo.R albedo.G albedo.B"}, {"beauty", "R G B A"}}},
         {101, 102, 103, 104},
         "layer 'beauty' of 2\n"},
        {{.parts = {{"albedo", "R G B"}, {"depth", "Z"}, {"RGBA", "R G B"}}},
         {201, 202, 203, 1},
         "layer 'RGBA' of 3\n"},
        {{.parts =
              {{NULL,
                "v.Combined.R v.Combined.G v.Combined.B v.Combined.A v.DiffCol.R v.DiffCol.G v.DiffCol.B"}}},
         {1, 2, 3, 4},
         "layer 'v.Combined' of 2\n"},
        {{.parts = {{NULL, "N.X N.Y N.Z c.B c.G c.R"}}}, {6, 5, 4, 1}, "layer 'c' of 2\n"},
        {{.parts = {{NULL, "Y"}}}, {1, 1, 1, 1}, ""},
        {{.parts = {{NULL, "A Y"}}}, {2, 2, 2, 1}, ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        expect_pixel(file_of(&cases[i].file), NULL, cases[i].rgba, cases[i].says);

    expect_refused(
        file_of(&(ExrFile){.parts = {{"left", "R G B"}, {"right", "R G B"}}}), NULL,
        "no layer is clearly the picture, so --layer has to name one: 'left' (R, G, B), 'right' (R, G, B)");
    expect_refused(file_of(&(ExrFile){.parts = {{NULL, "a.R a.G a.B b.R b.G b.B"}}}), NULL,
                   "'a' (R, G, B), 'b'");
    expect_refused(file_of(&(ExrFile){.parts = {{NULL, "Z"}}}), NULL, "'Z' (one channel)");
    expect_refused(file_of(&(ExrFile){.parts = {{NULL, "R G"}}}), NULL,
                   "'G' (one channel), 'R' (one channel)");
    expect_refused(file_of(&(ExrFile){.parts = {{NULL, "BY RY Y"}}}), NULL, "Y, RY and BY");
}

static void test_exr_layer(void **state) {
    (void)state;
    const char *path = file_of(&(ExrFile){.parts = {{"left", "R G B Z normal.X normal.Y normal.Z"},
                                                    {"right", "R G B Z samples.Y"},
                                                    {"beauty", "R G B"}}});
    expect_pixel(path, NULL, (float[]){201, 202, 203, 1}, "layer 'beauty' of 7\n");
    expect_pixel(path, "right", (float[]){101, 102, 103, 1}, "layer 'right' of 7\n");
    expect_pixel(path, "right.Z", (float[]){104, 104, 104, 1}, "layer 'right.Z' of 7\n");
    expect_pixel(path, "samples", (float[]){105, 105, 105, 1}, "layer 'samples' of 7\n");
    expect_pixel(path, "normal", (float[]){5, 6, 7, 1},
                 "layer 'normal' of 7\nX, Y, Z taken as red, green, blue\n");
    expect_refused(
        path, "norml",
        "no layer 'norml'; its layers: 'left' (R, G, B), 'left.Z' (one channel), 'normal' (X, Y, Z)");
    const char *pfm = support_path("a.pfm");
    Error error;
    Image image = image_create(1, 1);
    assert_true(image_write(&image, pfm, &(ImageWriteParams){0}, &error));
    image_free(&image);
    expect_refused(pfm, "normal", "only EXR has layers");
}

/* sRGB's white, and the grey of X = Y = Z, from IEC 61966-2-1. */
static void test_exr_colours(void **state) {
    (void)state;
    static const struct {
        float xyz[3], rgba[4];
    } cases[] = {{{0.95047F, 1, 1.08883F}, {1, 1, 1, 1}},
                 {{0.5F, 0.5F, 0.5F}, {0.60238F, 0.47415F, 0.45444F, 1}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *path = file_of(&(ExrFile){.parts = {{NULL, "X Y Z"}}, .values = cases[i].xyz});
        expect_pixel(path, NULL, cases[i].rgba, "X, Y, Z converted to linear sRGB (D65)\n");
    }
    expect_pixel(file_of(&(ExrFile){.parts = {{NULL, "R G B"}}, .aces = true}), NULL, (float[]){1, 2, 3, 1},
                 "its primaries or its white are not sRGB's: values are taken as they are\n");
}

static Image read_windows(Rectangle data, Rectangle display, const char *says) {
    Error error;
    Image image;
    Text said = {0};
    const char *path = file_of(&(ExrFile){.parts = {{NULL, "R G B"}}, .data = data, .display = display});
    if (!image_read_as(&image, path, &(ImageReadParams){.said = &said}, &error)) fail_msg("%s", error.text);
    assert_string_equal(text_string(&said), says);
    text_free(&said);
    for (int y = 0; y < image.height; y++) {
        for (int x = 0; x < image.width; x++) {
            int file_x = x + display.x - data.x, file_y = y + display.y - data.y;
            bool held = file_x >= 0 && file_x < data.width && file_y >= 0 && file_y < data.height;
            assert_int_equal(image_holds(&image, x, y), held);
            assert_true(image.rgba[4 * (y * image.width + x) + 1] == (held ? 2.0F : 0.0F));
            assert_true(image.rgba[4 * (y * image.width + x) + 3] == (held ? 1.0F : 0.0F));
        }
    }
    return image;
}

static void test_exr_windows(void **state) {
    (void)state;
    Error error;
    Comparison result;
    Rectangle display = {0, 0, 20, 10};
    Image all = read_windows(display, display, "");
    Image part = read_windows((Rectangle){10, 7, 5, 2}, display,
                              "display window of 20x10, data window of 5x2 at 10,7 in it\n");
    Image left = read_windows((Rectangle){-3, -4, 13, 35}, display,
                              "display window of 20x10, data window of 13x35 at -3,-4 in it\n");
    Image moved = read_windows((Rectangle){110, 217, 5, 2}, (Rectangle){105, 215, 20, 10},
                               "display window of 20x10, data window of 5x2 at 5,2 in it\n");
    assert_true(compare_images(&part, &all, NULL, &result, &error));
    assert_int_equal(result.pixels, 10);
    assert_int_equal(result.outside, 190);
    assert_true(result.rel_rmse_percent == 0);
    assert_false(compare_images(&part, &left, NULL, &result, &error));
    assert_non_null(strstr(error.text, "no pixel to compare"));
    Image small = image_create(5, 2);
    assert_false(compare_images(&small, &part, NULL, &result, &error));
    assert_non_null(strstr(error.text, "the reference 20x10 (its display window; its data are 5x2 at 10,7)"));

    ExrFile outside = {.parts = {{NULL, "R G B"}}, .data = {20, 0, 6, 10}, .display = display};
    expect_refused(file_of(&outside), NULL,
                   "data window (from 20,0 to 25,9) is outside of its display window (from 0,0 to 19,9)");
    ExrFile large = {.parts = {{NULL, "R G B"}}, .data = display, .display = {0, 0, 1048577, 10}};
    expect_refused(file_of(&large), NULL, "display window of 1048577x10");
    image_free(&all);
    image_free(&part);
    image_free(&left);
    image_free(&moved);
    image_free(&small);
}

/* tests/data/README.md says what the pictures hold. */
static double lossy_value(int x, int y, int c) {
    return 0.25 + 0.5 * x / 23 + 0.25 * c * y / 15;
}

static void test_exr_lossy(void **state) {
    (void)state;
    static const struct {
        const char *path, *layer;
        double tolerance;
    } cases[] = {{"tests/data/dwaa.exr", NULL, 0.02},
                 {"tests/data/dwab.exr", NULL, 0.02},
                 {"tests/data/b44.exr", NULL, 0.02},
                 {"tests/data/dwaa.exr", "copy", 0.02},
                 {"tests/data/dwaa.exr", "grey", 0.02}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Error error;
        Image image;
        if (!image_read_as(&image, cases[i].path, &(ImageReadParams){.layer = cases[i].layer}, &error))
            fail_msg("%s", error.text);
        bool grey = cases[i].layer && strcmp(cases[i].layer, "grey") == 0;
        assert_int_equal(image.width, 24);
        assert_int_equal(image.height, 16);
        for (int p = 0; p < 24 * 16; p++) {
            for (int c = 0; c < 3; c++) {
                double value = (double)image.rgba[4 * p + c],
                       exact = lossy_value(p % 24, p / 24, grey ? 0 : c);
                if (!(fabs(value - exact) <= cases[i].tolerance))
                    fail_msg("%s at %d,%d: %g instead of %g", cases[i].path, p % 24, p / 24, value, exact);
            }
            assert_true(image.rgba[4 * p + 3] == 1);
        }
        image_free(&image);
    }
}

/* A file that is cut is refused, with its name. */
static void test_exr_lossy_cut(void **state) {
    (void)state;
    Error error;
    Text file = {0};
    assert_true(file_read("tests/data/dwaa.exr", STATUS_FAILURE, &file, &error));
    for (size_t size = 0; size < file.size; size += 7) {
        Image image;
        Text cut = {.size = size, .data = memory_get(size + 1, 1)};
        memcpy(cut.data, file.data, size);
        assert_false(exr_decode(&image, "x", &cut, NULL, &error));
        assert_ptr_equal(strstr(error.text, "x: "), error.text);
        assert_null(strchr(error.text, '\n'));
        assert_null(image.rgba);
        text_free(&cut);
    }
    text_free(&file);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_exr_picture), cmocka_unit_test(test_exr_layer),
        cmocka_unit_test(test_exr_colours), cmocka_unit_test(test_exr_windows),
        cmocka_unit_test(test_exr_lossy),   cmocka_unit_test(test_exr_lossy_cut),
    };
    return cmocka_run_group_tests_name("exr", tests, support_folder, support_clean);
}
