/* Numbers, text and the command line. */
#include "support.h"

#include "base/options.h"
#include "base/text.h"

#include <math.h>
#include <string.h>

static void test_numbers(void **state) {
    (void)state;
    static const char *const bad[] = {"",   " ",  "nan",   "inf", "-inf", "0x10",  "1 ",
                                      " 1", "1e", "1e999", "--1", "1,2",  "1.2.3", "e5",
                                      "+",  ".",  "1f",    "INF", "NaN"};
    static const struct {
        const char *text;
        double value;
    } good[] = {{"0", 0}, {"-2.5", -2.5}, {"1e-3", 1e-3}, {".5", 0.5}, {"5.", 5}, {"+7", 7}, {"1E6", 1e6}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        double value = 42;
        if (number_parse(bad[i], &value)) fail_msg("'%s' taken as %g", bad[i], value);
        assert_true(value == 42);
    }
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        double value = 42;
        assert_true(number_parse(good[i].text, &value));
        assert_true(value == good[i].value);
    }
    unsigned long long count;
    assert_true(count_parse("4294967296", &count) && count == 4294967296ULL);
    assert_false(count_parse("-1", &count));
    assert_false(count_parse("+1", &count));
    assert_false(count_parse("1.5", &count));
    assert_false(count_parse("99999999999999999999", &count));
}

static void test_text(void **state) {
    (void)state;
    Text text = {0};
    assert_string_equal(text_string(&text), "");
    for (int i = 0; i < 1000; i++) text_print(&text, "%d,", i % 10);
    assert_int_equal(text.size, 2000);
    assert_int_equal(strlen(text_string(&text)), 2000);
    text_free(&text);
    Error error;
    error_set(&error, STATUS_SCENE, "%s", "what");
    assert_false(error_prefix(&error, "a.glsl:%d: ", 3));
    assert_string_equal(error.text, "a.glsl:3: what");
    assert_int_equal(error.status, STATUS_SCENE);
}

/* Parses a command line of words between blanks. */
static bool parse(Options *options, const char *line, Error *error) {
    static char words[512];
    char *argv[32] = {0};
    int argc = 0;
    strcpy(words, line);
    for (char *word = strtok(words, " "); word; word = strtok(NULL, " ")) argv[argc++] = word;
    return options_parse(options, argc, argv, error);
}

static void test_options(void **state) {
    (void)state;
    Options options;
    Error error;
    assert_true(parse(&options,
                      "magichour render a.glsl -o a.exr -o b.png --size 320x200 --sun -2.5,90 --set ball=0 "
                      "--sky=paper:64x16 --spp 9 --seed 7 --depth 8 --exposure -1 --quiet",
                      &error));
    assert_int_equal(options.command, COMMAND_RENDER);
    assert_string_equal(options.inputs[0], "a.glsl");
    assert_int_equal(options.output_count, 2);
    assert_int_equal(options.width, 320);
    assert_int_equal(options.height, 200);
    assert_true(options.has_sun && options.sun_elevation_deg == -2.5);
    assert_true(options.has_azimuth && options.sun_azimuth_deg == 90);
    assert_string_equal(options.settings[0], "ball=0");
    assert_string_equal(options.sky, "paper:64x16");
    assert_int_equal(options.samples, 9);
    assert_int_equal(options.seed, 7);
    assert_int_equal(options.depth, 8);
    assert_true(options.has_exposure && options.exposure_ev == -1);
    assert_true(options.quiet && isinf(options.max_bias_percent));
    assert_true(parse(&options, "magichour render -o a.exr -- -odd.glsl", &error));
    assert_string_equal(options.inputs[0], "-odd.glsl");
    assert_true(parse(&options, "magichour render a.glsl --sun 12", &error));
    assert_false(options.has_azimuth);
}

static void test_options_refused(void **state) {
    (void)state;
    static const struct {
        const char *line, *part;
    } cases[] = {
        {"magichour", "which command"},
        {"magichour paint", "unknown command 'paint'"},
        {"magichour render", "usage: magichour render SCENE"},
        {"magichour render a b", "'b' is one file too many"},
        {"magichour render a --frob", "unknown option '--frob'"},
        {"magichour compare a b --spp 3", "unknown option '--spp'"},
        {"magichour render a --spp", "--spp needs a value N"},
        {"magichour render a --spp 0", "'0' is not a whole number from 1"},
        {"magichour render a --spp 1.5", "'1.5' is not a whole number"},
        {"magichour render a --spp 5000000000", "not a whole number from 1 to 4294967295"},
        {"magichour render a --size 0x0", "at least 1x1"},
        {"magichour render a --size 10", "'10' is not WIDTHxHEIGHT"},
        {"magichour render a --size 10x", "not WIDTHxHEIGHT"},
        {"magichour render a --size -1x5", "not WIDTHxHEIGHT"},
        {"magichour render a --sun nan", "'nan' is not a number from -90 to 90"},
        {"magichour render a --sun 91", "'91' is not a number from -90 to 90"},
        {"magichour render a --sun 5,", "'' is not a number"},
        {"magichour render a --sun 5,400", "'400' is not a number from -360 to 360"},
        {"magichour render a --set ball", "'ball' is not NAME=VALUE"},
        {"magichour render a --set =3", "not NAME=VALUE"},
        {"magichour render a --quiet=1", "--quiet takes no value"},
        {"magichour render a --progress loud", "unknown 'loud' (known: tty, json, none)"},
        {"magichour render a --exposure inf", "not a number from -64 to 64"},
        {"magichour compare a b --max-bias x", "'x' is not a number"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Options options;
        Error error = {0};
        assert_false(parse(&options, cases[i].line, &error));
        assert_int_equal(error.status, STATUS_USAGE);
        if (!strstr(error.text, cases[i].part)) fail_msg("%s: %s", cases[i].line, error.text);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_numbers),
        cmocka_unit_test(test_text),
        cmocka_unit_test(test_options),
        cmocka_unit_test(test_options_refused),
    };
    return cmocka_run_group_tests_name("base", tests, NULL, NULL);
}
