/* Numbers, text and words that are near. */
#include "support.h"

#include "base/near.h"
#include "base/number.h"
#include "base/text.h"

#include <stdio.h>
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

/* A shell reads each word back as it was. */
static void test_quoted(void **state) {
    (void)state;
    static char *const words[] = {
        "printf",    "%s.",    "plain/a-b_c.glsl", "two words", "it's",      "", "$HOME `id` \\",
        "\"q\" \t!", "line\n", "#a;b|c&d<e>(f)*?", "~",         "--set=x=1", "'"};
    enum { WORDS = sizeof words / sizeof *words };
    Text command = {0}, expected = {0};
    char got[512] = "";
    for (int i = 2; i < WORDS; i++) text_print(&expected, "%s.", words[i]);
    text_print_command(&command, WORDS, words);
    assert_non_null(strstr(text_string(&command), " plain/a-b_c.glsl 'two words' "));
    FILE *shell = popen(text_string(&command), "r");
    assert_non_null(shell);
    assert_true(fread(got, 1, sizeof got - 1, shell) > 0);
    assert_int_equal(pclose(shell), 0);
    assert_string_equal(got, text_string(&expected));
    text_free(&command);
    text_free(&expected);
}

static void test_near(void **state) {
    (void)state;
    static const char *const names[] = {"render", "crater", "gyroid", "--exposure", "sky", "box-room"};
    static const struct {
        const char *word, *name;
    } cases[] = {
        {"crater", "crater"},        {"cratre", "crater"}, {"creatr", "crater"},   {"gyriod", "gyroid"},
        {"--exposre", "--exposure"}, {"skz", "sky"},       {"skzz", NULL},         {"", NULL},
        {"box_room", "box-room"},    {"moon", NULL},       {"boxroom", "box-room"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Near near = near_to(cases[i].word, strlen(cases[i].word));
        for (size_t k = 0; k < sizeof names / sizeof *names; k++) near_try(&near, names[k]);
        const char *expected = cases[i].name;
        if (expected ? !near.name || strcmp(near.name, expected) != 0 : near.name != NULL)
            fail_msg("'%s': found %s", cases[i].word, near.name ? near.name : "nothing");
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_numbers),
        cmocka_unit_test(test_text),
        cmocka_unit_test(test_quoted),
        cmocka_unit_test(test_near),
    };
    return cmocka_run_group_tests_name("base", tests, NULL, NULL);
}
