/* The difference of two pictures in false colours, and the labels of its scale. */
#include "support.h"

#include "image/difference.h"
#include "image/label.h"
#include "image/levels.h"

#include <math.h>
#include <string.h>

enum { SIDE = 20, PIXELS = SIDE * SIDE };

static Image grey_image(int side, double level) {
    Image image = image_create(side, side);
    image.shown = true;
    for (int i = 0; i < 4 * side * side; i++) image.rgba[i] = (float)tone_light_of_level(level);
    return image;
}

static void level_set(Image *image, int pixel, int channel, double level) {
    image->rgba[4 * pixel + channel] = (float)tone_light_of_level(level);
}

static void assert_level(double value, double expected) {
    if (!(fabs(value - expected) < 1e-4)) fail_msg("%g instead of %g", value, expected);
}

/* The levels of sRGB there and back, through both parts of its curve. */
static void test_difference_tone(void **state) {
    (void)state;
    for (int level = 0; level <= 255; level++)
        assert_level(tone_level(TONE_NONE, 1, tone_light_of_level(level)), level);
    assert_true(tone_light_of_level(255) == 1);
}

static void test_difference_at(void **state) {
    (void)state;
    Image a = grey_image(SIDE, 100), b = grey_image(SIDE, 100);
    unsigned char compared[PIXELS];
    memset(compared, 1, sizeof compared);
    DifferenceParams params = {.a = &a, .b = &b, .compared = compared, .tone = TONE_AUTHOR, .exposure_ev = 3};
    level_set(&a, 21, 0, 106);
    level_set(&a, 21, 1, 97);
    level_set(&a, 22, 2, 97);
    assert_true(difference_at(&params, 0, 0) == 0);
    /* Pictures that are shown already have neither a curve nor an exposure. */
    assert_level(difference_at(&params, 1, 1), sqrt((36 + 9) / 3.0));
    assert_level(difference_at(&params, 2, 1), -sqrt(9 / 3.0));

    a.shown = b.shown = false;
    a.rgba[0] = 0.3F;
    b.rgba[0] = 0.2F;
    double exact = tone_level(TONE_AUTHOR, 8, (double)0.3F) - tone_level(TONE_AUTHOR, 8, (double)0.2F);
    assert_level(difference_at(&params, 0, 0), exact / sqrt(3));
    image_free(&a);
    image_free(&b);
}

/* Of 400 pixels, 4 may lie above the range. */
static void test_difference_range(void **state) {
    (void)state;
    Image a = grey_image(SIDE, 100), b = grey_image(SIDE, 100);
    unsigned char compared[PIXELS];
    memset(compared, 1, sizeof compared);
    DifferenceParams params = {.a = &a, .b = &b, .compared = compared};
    assert_true(difference_range(&params) == 1);
    for (int i = 0; i < 4; i++) {
        for (int c = 0; c < 3; c++) level_set(&a, i, c, 60);
    }
    assert_true(difference_range(&params) == 1);
    for (int c = 0; c < 3; c++) level_set(&a, 4, c, 109);
    assert_true(difference_range(&params) == 10);
    compared[4] = 0;
    assert_true(difference_range(&params) == 50);
    compared[0] = 0;
    assert_true(difference_range(&params) == 1);
    for (int i = 0; i < 4 * PIXELS; i++) a.rgba[i] = 1;
    assert_true(difference_range(&params) == 255);
    image_free(&a);
    image_free(&b);
}

static void assert_colour(const Image *image, int x, int y, double red, double green, double blue) {
    const double expected[3] = {red, green, blue};
    for (int c = 0; c < 3; c++) {
        double level = image_level(image, (size_t)(4 * (y * image->width + x) + c), TONE_NONE, 0);
        if (!(fabs(level - 255 * expected[c]) < 0.51))
            fail_msg("%d,%d: channel %d is %g instead of %g", x, y, c, level / 255, expected[c]);
    }
}

/* The colours' ends and middle, in the picture and in its scale, and the pixels that are not compared. */
static void test_difference_picture(void **state) {
    (void)state;
    enum { LEFT = 8, TOP = 26, LARGE = 70, BAR = LEFT + LARGE + 8 };
    Image a = grey_image(LARGE, 100), b = grey_image(LARGE, 100);
    unsigned char compared[LARGE * LARGE];
    memset(compared, 1, sizeof compared);
    for (int c = 0; c < 3; c++) {
        level_set(&a, LARGE + 1, c, 101);
        level_set(&a, LARGE + 2, c, 99);
        level_set(&a, LARGE + 3, c, 100.5);
    }
    compared[4] = compared[5] = 0;
    a.rgba[4 * 5] = NAN;
    Image picture =
        difference_picture(&(DifferenceParams){.a = &a, .b = &b, .compared = compared, .tone = TONE_AUTHOR});
    assert_true(picture.shown);
    assert_colour(&picture, LEFT, TOP, 0.865, 0.865, 0.865);
    assert_colour(&picture, LEFT + 1, TOP + 1, 0.706, 0.016, 0.150);
    assert_colour(&picture, LEFT + 2, TOP + 1, 0.230, 0.299, 0.754);
    assert_colour(&picture, LEFT + 3, TOP + 1, (0.865 + 0.706) / 2, (0.865 + 0.016) / 2, (0.865 + 0.150) / 2);
    assert_colour(&picture, LEFT + 4, TOP, 0, 0, 0);
    assert_colour(&picture, LEFT + 5, TOP, 1, 1, 0);
    assert_true(picture.rgba[4 * (TOP * picture.width + BAR)] > 0.4F);
    assert_true(picture.rgba[4 * ((TOP + LARGE - 1) * picture.width + BAR) + 2] > 0.4F);
    assert_colour(&picture, LEFT - 1, TOP, 1, 1, 1);

    /* The first label is "+1": its plus has a bar of 3 points of 2 pixels. */
    int label = BAR + 16 + 4;
    for (int x = 0; x < 6; x++) assert_colour(&picture, label + x, TOP + 4, 0, 0, 0);
    assert_colour(&picture, label + 6, TOP + 4, 1, 1, 1);
    image_free(&picture);
    image_free(&a);
    image_free(&b);
}

/* What does not fit is left out, and unknown letters are blanks. */
static void test_difference_label(void **state) {
    (void)state;
    Image image = image_create(12, 7);
    label_draw(&image, "?7", 1, 1, 1, 1);
    static const char *const rows[] = {"            ", "     ###    ", "       #    ", "       #    ",
                                       "       #    ", "       #    ", "            "};
    for (int y = 0; y < 7; y++) {
        for (int x = 0; x < 12; x++)
            assert_true(image.rgba[4 * (y * 12 + x)] == (rows[y][x] == '#' ? 1.0F : 0.0F));
    }
    label_draw(&image, "88888", -3, -2, 3, 1);
    label_draw(&image, "8", 11, 6, 9, 1);
    assert_true(image.rgba[4 * (6 * 12 + 11)] == 1);
    image_free(&image);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_difference_tone),  cmocka_unit_test(test_difference_at),
        cmocka_unit_test(test_difference_range), cmocka_unit_test(test_difference_picture),
        cmocka_unit_test(test_difference_label),
    };
    return cmocka_run_group_tests_name("difference", tests, NULL, NULL);
}
