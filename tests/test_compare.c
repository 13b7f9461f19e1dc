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
    assert_true(compare_images(&a, &b, &se, NULL, &result, &error));
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
    assert_true(compare_images(&a, &b, NULL, NULL, &result, &error));
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
    assert_true(compare_images(&a, &b, NULL, NULL, &result, &error));
    double squares = 0;
    for (int i = 1; i <= 30; i++) squares += i * i;
    assert_near(result.rel_rmse_percent, 100 * sqrt(squares / 6000) / 4);
    squares -= 30 * 30 + 29 * 29;
    assert_near(result.trimmed_percent, 100 * sqrt(squares / 5994) / 4);
    assert_near(result.largest_percent, 100 * 30 / 4.0);
    assert_near(result.p99_percent, 0);
    for (int i = 0; i < 30; i++) a.rgba[4 * (i * 61 + 5) + 2] = 4 - 0.5F * (float)(i + 1);
    assert_true(compare_images(&a, &b, NULL, NULL, &result, &error));
    /* 60 values differ: the 5940th is the last that does not. One more, and it is the smallest that does. */
    assert_near(result.p99_percent, 0);
    a.rgba[0] = 4.25F;
    assert_true(compare_images(&a, &b, NULL, NULL, &result, &error));
    assert_near(result.p99_percent, 100 * 0.25 / 4);
    image_free(&a);
    image_free(&b);
}

static void test_compare_mask(void **state) {
    (void)state;
    Error error;
    Comparison result;
    Image a = constant_image(3, 1, 1), b = constant_image(3, 1, 2), mask = constant_image(3, 1, 0);
    assert_false(compare_images(&a, &b, NULL, &mask, &result, &error));
    assert_int_equal(error.status, STATUS_USAGE);
    mask.rgba[4] = 1;
    mask.rgba[8] = 0.5F; /* not above */
    a.rgba[0] = NAN;     /* masked: not counted */
    a.rgba[4] = 3;
    assert_true(compare_images(&a, &b, NULL, &mask, &result, &error));
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
    assert_true(compare_images(&zero, &zero, &zero, NULL, &result, &error));
    assert_near(result.rel_rmse_percent, 0);
    assert_near(result.bias_percent[2], 0);
    assert_false(result.has_z);
    assert_true(compare_images(&one, &zero, NULL, NULL, &result, &error));
    assert_true(isinf(result.rel_rmse_percent) && isinf(result.bias_percent[0]) && isinf(result.p99_percent));
    for (int i = 0; i < 4 * 6; i++) zero.rgba[i] = NAN;
    assert_true(compare_images(&zero, &one, NULL, NULL, &result, &error));
    assert_int_equal(result.nonfinite, 6);
    assert_true(isinf(result.rel_rmse_percent) && isinf(result.bias_percent[0]));

    assert_false(compare_images(&other, &one, NULL, NULL, &result, &error));
    assert_int_equal(error.status, STATUS_USAGE);
    assert_non_null(strstr(error.text, "2x3"));
    assert_false(compare_images(&one, &one, &other, NULL, &result, &error));
    assert_false(compare_images(&one, &one, NULL, &other, &result, &error));
    image_free(&one);
    image_free(&zero);
    image_free(&other);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_compare_figures),
        cmocka_unit_test(test_compare_ranks),
        cmocka_unit_test(test_compare_mask),
        cmocka_unit_test(test_compare_limits),
    };
    return cmocka_run_group_tests_name("compare", tests, NULL, NULL);
}
