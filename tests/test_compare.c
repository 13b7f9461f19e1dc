/* The errors between two pictures. */
#include "support.h"

#include "image/compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void assert_near(double value, double expected) {
    if (!(fabs(value - expected) <= 1e-9 * fabs(expected)))
        fail_msg("%.17g instead of %.17g", value, expected);
}

static Image constant_image(int width, int height, float value) {
    Image image = image_create(width, height);
    for (int i = 0; i < 4 * width * height; i++) image.rgba[i] = value;
    return image;
}

static void test_compare_figures(void **state) {
    (void)state;
    Error error;
    Comparison result;
    /* a is 2 everywhere, but red is 3 in one pixel of four; b is 2. Alpha does not count. */
    Image a = constant_image(2, 2, 2), b = constant_image(2, 2, 2), se = constant_image(2, 2, 0.2F);
    a.rgba[4] = 3;
    a.rgba[7] = 100;
    se.rgba[8] = se.rgba[9] = 0;
    se.rgba[10] = NAN;
    assert_true(compare_images(&a, &b, &(CompareOptions){.standard_error = &se}, &result, &error));
    assert_int_equal(result.pixels, 4);
    assert_int_equal(result.nonfinite, 0);
    assert_near(result.rel_rmse_percent, 100 * sqrt(1.0 / 12) / 2);
    assert_near(result.trimmed_percent, 0);
    assert_near(result.bias_percent[0], 12.5);
    assert_near(result.bias_percent[1], 0);
    assert_near(result.largest_percent, 50);
    assert_near(result.p99_percent, 50);
    assert_true(result.has_z);
    assert_near(result.mean_z2, 1 / ((double)0.2F * (double)0.2F) / 9);
    assert_near(result.share_z4_percent, 100.0 / 9);

    a.rgba[8] = NAN;
    b.rgba[13] = INFINITY;
    assert_true(compare_images(&a, &b, NULL, &result, &error));
    assert_int_equal(result.pixels, 4);
    assert_int_equal(result.nonfinite, 2);
    assert_near(result.rel_rmse_percent, 100 * sqrt(1.0 / 6) / 2);
    assert_false(result.has_z);
    image_free(&a);
    image_free(&b);
    image_free(&se);
}

/* 2000 pixels: the two worst are dropped, and the 99th percentile is the 5940th of 6000 values. */
static void test_compare_ranks(void **state) {
    (void)state;
    Error error;
    Comparison result;
    Image a = constant_image(50, 40, 4), b = constant_image(50, 40, 4);
    for (int i = 0; i < 30; i++) a.rgba[4 * (i * 61 + 5) + 1] = 4 + (float)(i + 1);
    assert_true(compare_images(&a, &b, NULL, &result, &error));
    double squares = 0;
    for (int i = 1; i <= 30; i++) squares += i * i;
    assert_near(result.rel_rmse_percent, 100 * sqrt(squares / 6000) / 4);
    squares -= 30 * 30 + 29 * 29;
    assert_near(result.trimmed_percent, 100 * sqrt(squares / 5994) / 4);
    assert_near(result.largest_percent, 100 * 30 / 4.0);
    assert_near(result.p99_percent, 0);
    for (int i = 0; i < 30; i++) a.rgba[4 * (i * 61 + 5) + 2] = 4 - 0.5F * (float)(i + 1);
    assert_true(compare_images(&a, &b, NULL, &result, &error));
    /* 60 values differ: the 5940th is the last that does not. One more, and it is the smallest that does. */
    assert_near(result.p99_percent, 0);
    a.rgba[0] = 4.25F;
    assert_true(compare_images(&a, &b, NULL, &result, &error));
    assert_near(result.p99_percent, 100 * 0.25 / 4);
    image_free(&a);
    image_free(&b);
}

static void test_compare_mask(void **state) {
    (void)state;
    Error error;
    Comparison result;
    Image a = constant_image(3, 1, 1), b = constant_image(3, 1, 2), mask = constant_image(3, 1, 0);
    assert_false(compare_images(&a, &b, &(CompareOptions){.mask = &mask}, &result, &error));
    assert_int_equal(error.status, STATUS_USAGE);
    mask.rgba[4] = 1;
    mask.rgba[8] = 0.5F; /* not above */
    a.rgba[0] = NAN;     /* masked: not counted */
    a.rgba[4] = 3;
    assert_true(compare_images(&a, &b, &(CompareOptions){.mask = &mask}, &result, &error));
    assert_int_equal(result.pixels, 1);
    assert_int_equal(result.nonfinite, 0);
    assert_near(result.bias_percent[0], 50);
    assert_near(result.bias_percent[1], -50);
    assert_near(result.rel_rmse_percent, 50);
    assert_near(result.trimmed_percent, 50); /* one pixel always remains */
    image_free(&a);
    image_free(&b);
    image_free(&mask);
}

static void test_compare_limits(void **state) {
    (void)state;
    Error error;
    Comparison result;
    Image one = constant_image(3, 2, 1), zero = constant_image(3, 2, 0), other = constant_image(2, 3, 1);
    assert_true(compare_images(&zero, &zero, &(CompareOptions){.standard_error = &zero}, &result, &error));
    assert_near(result.rel_rmse_percent, 0);
    assert_near(result.bias_percent[2], 0);
    assert_false(result.has_z);
    assert_true(compare_images(&one, &zero, NULL, &result, &error));
    assert_true(isinf(result.rel_rmse_percent) && isinf(result.bias_percent[0]) && isinf(result.p99_percent));
    for (int i = 0; i < 4 * 6; i++) zero.rgba[i] = NAN;
    assert_true(compare_images(&zero, &one, NULL, &result, &error));
    assert_int_equal(result.nonfinite, 6);
    assert_true(isinf(result.rel_rmse_percent) && isinf(result.bias_percent[0]));

    assert_false(compare_images(&other, &one, NULL, &result, &error));
    assert_int_equal(error.status, STATUS_USAGE);
    assert_non_null(strstr(error.text, "2x3"));
    assert_false(compare_images(&one, &one, &(CompareOptions){.standard_error = &other}, &result, &error));
    assert_false(compare_images(&one, &one, &(CompareOptions){.mask = &other}, &result, &error));
    image_free(&one);
    image_free(&zero);
    image_free(&other);
}

/* Of 1000 pixels one is trimmed, and its radiance is not in the mean either. Of pixels that differ alike, one
 * is kept. */
static void test_compare_trimmed(void **state) {
    (void)state;
    Error error;
    Comparison result;
    Image a = constant_image(50, 20, 4), b = constant_image(50, 20, 4);
    for (int c = 0; c < 3; c++) {
        a.rgba[4 * 77 + c] = 3e6F;
        b.rgba[4 * 77 + c] = 2e6F;
    }
    a.rgba[4 * 500] = 6;
    assert_true(compare_images(&a, &b, NULL, &result, &error));
    assert_near(result.trimmed_percent, 100 * sqrt(4.0 / (3 * 999)) / 4);
    for (int c = 0; c < 3; c++) a.rgba[4 * 77 + c] = b.rgba[4 * 77 + c] = 4;
    a.rgba[4 * 600] = 2;
    assert_true(compare_images(&a, &b, NULL, &result, &error));
    assert_near(result.trimmed_percent, 100 * sqrt(4.0 / (3 * 999)) / 4);
    image_free(&a);
    image_free(&b);
}

/* The sun's pixels are in no figure, and are counted where the mask admits them. */
static void test_compare_sun(void **state) {
    (void)state;
    Error error;
    Comparison with, without;
    Image a = constant_image(20, 20, 1), b = constant_image(20, 20, 1), mask = constant_image(20, 20, 1);
    unsigned char sun[400] = {0};
    a.rgba[4 * 3] = 2;
    assert_true(compare_images(&a, &b, NULL, &without, &error));
    for (int i = 100; i < 110; i++) {
        sun[i] = 1;
        a.rgba[4 * i] = i % 2 ? NAN : 1e5F;
        b.rgba[4 * i + 1] = 3e5F;
    }
    assert_true(compare_images(&a, &b, &(CompareOptions){.sun = sun}, &with, &error));
    assert_int_equal(with.sun_pixels, 10);
    assert_int_equal(with.pixels, 390);
    assert_int_equal(with.nonfinite, 0);
    assert_near(with.rel_rmse_percent, 100 * sqrt(1.0 / (3 * 390)));
    assert_near(with.largest_percent, 100);
    assert_near(with.bias_percent[0], 100.0 / 390);
    assert_near(with.bias_percent[1], 0);
    assert_near(with.levels.rms * sqrt(390), without.levels.rms * sqrt(400));

    mask.rgba[4 * 100L] = mask.rgba[0] = 0;
    assert_true(compare_images(&a, &b, &(CompareOptions){.sun = sun, .mask = &mask}, &with, &error));
    assert_int_equal(with.sun_pixels, 9);
    assert_int_equal(with.pixels, 389);
    memset(sun, 1, sizeof sun);
    assert_false(compare_images(&a, &b, &(CompareOptions){.sun = sun}, &with, &error));
    assert_int_equal(error.status, STATUS_USAGE);
    assert_non_null(strstr(error.text, "sun"));
    image_free(&a);
    image_free(&b);
    image_free(&mask);
}

/* 40x36 pixels are 3x3 tiles. The right ones are 8 pixels wide, and the lower ones 4 high: those of 16x4
 * pixels count, that of 8x4 in the corner does not. */
static void test_compare_levels(void **state) {
    (void)state;
    enum { WIDTH = 40, HEIGHT = 36 };
    Error error;
    Comparison result;
    Image a = constant_image(WIDTH, HEIGHT, 0), b = constant_image(WIDTH, HEIGHT, 0);
    /* On the line at the foot of the encoding, a level is a radiance of 1 / (255 * 12.92). */
    float level = (float)(1 / (255 * 12.92));
    CompareOptions options = {.tone = TONE_NONE};
    a.rgba[4 * (35 * WIDTH + 39)] = 6 * level; /* in the corner */
    assert_true(compare_images(&a, &b, &options, &result, &error));
    assert_true(fabs(result.levels.rms - 6 / sqrt(3.0 * WIDTH * HEIGHT)) < 1e-6);
    assert_true(result.levels.worst_tile == 0);

    a.rgba[4 * (33 * WIDTH + 20) + 2] = 2 * level; /* in the tile of 16x4 pixels at 16,32 */
    a.rgba[4 * (3 * WIDTH + 3) + 1] = 3 * level;   /* in the whole tile at 0,0 */
    assert_true(compare_images(&a, &b, &options, &result, &error));
    assert_true(fabs(result.levels.rms - sqrt((36 + 4 + 9) / (3.0 * WIDTH * HEIGHT))) < 1e-6);
    assert_true(fabs(result.levels.worst_tile - 2 / sqrt(3.0 * 64)) < 1e-6);
    assert_int_equal(result.levels.worst_x, 16);
    assert_int_equal(result.levels.worst_y, 32);

    /* One pixel less, and that tile counts no more. */
    b.rgba[4 * (32 * WIDTH + 16)] = NAN;
    assert_true(compare_images(&a, &b, &options, &result, &error));
    assert_true(fabs(result.levels.worst_tile - 3 / sqrt(3.0 * 256)) < 1e-6);
    assert_int_equal(result.levels.worst_x, 0);
    assert_int_equal(result.levels.worst_y, 0);

    /* A stop brighter is two times as far on the line. What is above white on both sides is the same. */
    options.exposure_ev = 1;
    assert_true(compare_images(&a, &b, &options, &result, &error));
    assert_true(fabs(result.levels.worst_tile - 6 / sqrt(3.0 * 256)) < 1e-6);
    a.rgba[0] = 5;
    b.rgba[0] = 7;
    assert_true(compare_images(&a, &b, &options, &result, &error));
    assert_true(fabs(result.levels.worst_tile - 6 / sqrt(3.0 * 256)) < 1e-6);
    options.tone = TONE_AUTHOR;
    assert_true(compare_images(&a, &b, &options, &result, &error));
    assert_true(result.levels.worst_tile > 0 && result.levels.worst_tile < 3 / sqrt(3.0 * 256));
    image_free(&a);
    image_free(&b);
}

/* No tile of a small picture has enough pixels: the figure is that of all. */
static void test_compare_levels_small(void **state) {
    (void)state;
    Error error;
    Comparison result;
    Image a = constant_image(7, 7, 0.2F), b = constant_image(7, 7, 0.3F);
    assert_true(compare_images(&a, &b, NULL, &result, &error));
    double exact = tone_level(TONE_AUTHOR, 1, (double)0.3F) - tone_level(TONE_AUTHOR, 1, (double)0.2F);
    assert_near(result.levels.rms, exact);
    assert_near(result.levels.worst_tile, exact);
    for (int i = 0; i < 4 * 49; i++) a.rgba[i] = NAN;
    assert_true(compare_images(&a, &b, NULL, &result, &error));
    assert_true(isinf(result.levels.rms) && isinf(result.levels.worst_tile));
    image_free(&a);
    image_free(&b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_compare_figures),      cmocka_unit_test(test_compare_ranks),
        cmocka_unit_test(test_compare_mask),         cmocka_unit_test(test_compare_trimmed),
        cmocka_unit_test(test_compare_sun),          cmocka_unit_test(test_compare_levels),
        cmocka_unit_test(test_compare_levels_small), cmocka_unit_test(test_compare_limits),
    };
    return cmocka_run_group_tests_name("compare", tests, NULL, NULL);
}
