/* How radiances are shown: the tone curve, and the pixels that hold the sun's image. */
#include "support.h"

#include "image/sun_pixels.h"
#include "image/tone_table.h"

#include <math.h>
#include <string.h>

static void test_tone_ends(void **state) {
    (void)state;
    for (int tone = TONE_AUTHOR; tone <= TONE_NONE; tone++) {
        assert_true(tone_level((Tone)tone, 1, 0) == 0);
        assert_true(tone_level((Tone)tone, 1, -3) == 0);
        assert_true(tone_level((Tone)tone, 1, NAN) == 0);
        assert_true(tone_level((Tone)tone, 1, -INFINITY) == 0);
        assert_true(fabs(tone_level((Tone)tone, 1, INFINITY) - 255) < 1e-9);
        assert_true(fabs(tone_level((Tone)tone, 1, 1e300) - 255) < 1e-9);
    }
}

/* The curve rises strictly below its end, and at no place by a jump. */
static void test_tone_rises(void **state) {
    (void)state;
    for (int tone = TONE_AUTHOR; tone <= TONE_NONE; tone++) {
        double before = 0;
        for (double x = 0.001; x < 20; x += 0.001) {
            double level = tone_level((Tone)tone, 1, x);
            if (before < 254.999)
                assert_true(level > before);
            else
                assert_true(level >= before);
            assert_true(level - before < 3.5);
            before = level;
        }
        assert_true(fabs(before - 255) < 1e-9);
    }
}

/* Middle grey of sRGB; the curve at 1 is 2.54 / 3.16, and the gain multiplies the radiance. */
static void test_tone_values(void **state) {
    (void)state;
    assert_true(fabs(tone_level(TONE_NONE, 1, 0.18) - 117.6) < 0.1);
    double one = 255 * (1.055 * pow(2.54 / 3.16, 1 / 2.4) - 0.055);
    assert_true(fabs(tone_level(TONE_AUTHOR, 1, 1) - one) < 1e-9);
    assert_true(fabs(tone_level(TONE_AUTHOR, 8, 0.125) - one) < 1e-9);
    /* Below 0.0031308 the encoding is a line. */
    assert_true(fabs(tone_level(TONE_NONE, 0.5, 0.002) - 255 * 12.92 * 0.001) < 1e-9);
}

static void assert_sun_text(const char *rows, int width, const char *expected) {
    int height = (int)strlen(rows) / width;
    unsigned char mask[64] = {0}, again[64] = {0};
    Text text = {0};
    Error error;
    for (int i = 0; i < width * height; i++) mask[i] = rows[i] == '#';
    sun_pixels_print(mask, width, height, &text);
    assert_string_equal(text_string(&text), expected);
    assert_true(sun_pixels_parse(text_string(&text), again, width, height, &error));
    assert_memory_equal(mask, again, sizeof mask);
    text_free(&text);
}

static void test_sun_pixels_text(void **state) {
    (void)state;
    assert_sun_text("......", 3, "");
    assert_sun_text("######", 3, "0,0,3,2");
    assert_sun_text("#", 1, "0,0,1,1");
    assert_sun_text("#.##"
                    "#.##"
                    "...#"
                    ".###"
                    "####",
                    4, "0,0,1,2 2,0,2,2 3,2,1,1 1,3,3,1 0,4,4,1");
    /* Runs that differ at one end only are not merged, and equal runs with a gap between them are not. */
    assert_sun_text(".##."
                    "###."
                    ".##."
                    "...."
                    ".##.",
                    4, "1,0,2,1 0,1,3,1 1,2,2,1 1,4,2,1");
}

/* Every mask of 4x3 pixels comes back. */
static void test_sun_pixels_round(void **state) {
    (void)state;
    enum { WIDTH = 4, HEIGHT = 3, PIXELS = WIDTH * HEIGHT };
    Error error;
    for (unsigned bits = 0; bits < 1U << PIXELS; bits++) {
        unsigned char mask[PIXELS], again[PIXELS] = {0};
        Text text = {0};
        for (int i = 0; i < PIXELS; i++) mask[i] = bits >> i & 1;
        sun_pixels_print(mask, WIDTH, HEIGHT, &text);
        if (!sun_pixels_parse(text_string(&text), again, WIDTH, HEIGHT, &error)) fail_msg("%s", error.text);
        assert_memory_equal(mask, again, PIXELS);
        text_free(&text);
    }
}

static void test_sun_pixels_refused(void **state) {
    (void)state;
    static const char *const malformed[] = {" ",         "1",
                                            "1,1,1",     "1,1,1,",
                                            "1,1,1,1 ",  "1,1,1,1  2,2,1,1",
                                            " 1,1,1,1",  "1,1,1,1,",
                                            "-1,0,1,1",  "a,1,1,1",
                                            "1,1,1,1.0", "1,1,1,1,2,2,1,1",
                                            "1,1, 1,1",  "99999999999999999999,0,1,1"};
    static const char *const outside[] = {
        "7,0,2,1", "0,5,1,2", "8,0,1,1", "0,6,1,1", "0,0,0,1", "0,0,1,0", "1,1,1,1 0,0,999999999,1"};
    unsigned char mask[8 * 6] = {0};
    Error error;
    for (size_t i = 0; i < sizeof malformed / sizeof *malformed; i++) {
        if (sun_pixels_parse(malformed[i], mask, 8, 6, &error)) fail_msg("'%s' is taken", malformed[i]);
        assert_non_null(strstr(error.text, "is not 'X,Y,WIDTH,HEIGHT'"));
        assert_int_equal(error.status, STATUS_FAILURE);
    }
    for (size_t i = 0; i < sizeof outside / sizeof *outside; i++) {
        if (sun_pixels_parse(outside[i], mask, 8, 6, &error)) fail_msg("'%s' is taken", outside[i]);
        assert_non_null(strstr(error.text, "is not inside of the picture of 8x6"));
    }
    /* The first rectangle of the last text was set, and nothing else. */
    for (int i = 0; i < 8 * 6; i++) assert_int_equal(mask[i], i == 9);
    assert_true(sun_pixels_parse("7,5,1,1", mask, 8, 6, &error));
    assert_int_equal(mask[47], 1);
    assert_int_equal(mask[9], 1);
}

/* The table is the curve, in the dark, at its ends and between its knots. */
static void test_tone_table(void **state) {
    (void)state;
    for (int i = 0; i < 2; i++) {
        Tone tone = i ? TONE_NONE : TONE_AUTHOR;
        double gain = i ? 0.37 : 4, most = 0;
        ToneTable table = tone_table(tone, gain);
        for (double x = 1e-9; x < 1e9; x *= 1.0037)
            most = fmax(most, fabs((double)tone_table_level(&table, (float)x) - tone_level(tone, gain, x)));
        print_message("the table errs by %.2g levels\n", most);
        assert_true(most < 4e-3);
        assert_true(tone_table_level(&table, 0) == 0 && tone_table_level(&table, -1) == 0);
        assert_true(tone_table_level(&table, NAN) == 0 && tone_table_level(&table, INFINITY) > 254.99F);
        assert_true(tone_levels_per_percent(tone) > 0.5 && tone_levels_per_percent(tone) < 2);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tone_ends),          cmocka_unit_test(test_tone_rises),
        cmocka_unit_test(test_tone_values),        cmocka_unit_test(test_tone_table),
        cmocka_unit_test(test_sun_pixels_text),    cmocka_unit_test(test_sun_pixels_round),
        cmocka_unit_test(test_sun_pixels_refused),
    };
    return cmocka_run_group_tests_name("tone", tests, NULL, NULL);
}
