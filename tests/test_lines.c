/* The reader of lines and the writer of JSON lines. */
#include "support.h"

#include "base/json.h"
#include "base/lines.h"

#include <math.h>
#include <string.h>

/* Lines of any ending, numbered; the caller may cut them. */
static void test_lines(void **state) {
    (void)state;
    static const char *const expected[] = {"one", "", "three, cut", " \r four"};
    const char *text = "one\r\n\nthree, cut\n \r four";
    Lines lines = lines_of(text);
    int count = 0;
    for (char *line; (line = lines_next(&lines)); count++) {
        assert_true(count < 4);
        assert_string_equal(line, expected[count]);
        assert_int_equal(lines.number, count + 1);
        assert_int_equal(lines.ended, count < 3);
        if (strchr(line, ',')) *strchr(line, ',') = 0;
    }
    assert_int_equal(count, 4);
    lines_free(&lines);

    lines = lines_of("");
    assert_null(lines_next(&lines));
    lines_free(&lines);
}

static void test_lines_read(void **state) {
    (void)state;
    Text text = {0};
    Error error;
    assert_true(lines_read(support_write("marked.txt", "\xef\xbb\xbf//@"), STATUS_SCENE, &text, &error));
    assert_string_equal(text_string(&text), "//@");
    text_free(&text);

    FILE *file = fopen(support_path("binary"), "wb");
    assert_non_null(file);
    assert_int_equal(fwrite("a\0b", 1, 3, file), 3);
    fclose(file);
    assert_false(lines_read(support_path("binary"), STATUS_USAGE, &text, &error));
    assert_int_equal(error.status, STATUS_USAGE);
    assert_non_null(strstr(error.text, "binary:1: not a text file"));
    text_free(&text);
}

/* A line is one JSON object whatever the words in it; numbers that JSON has no word for are null. */
static void test_json(void **state) {
    (void)state;
    char got[256];
    FILE *file = tmpfile();
    Json json = json_begin();
    json_text(&json, "at", "a \"path\" \\ of\ttabs\n");
    json_number(&json, "x", 0.1);
    json_number(&json, "no", NAN);
    json_number(&json, "endless", -INFINITY);
    json_seconds(&json, "clock", 1234567.0000014);
    json_count(&json, "n", 18446744073709551615ULL);
    json_flag(&json, "done", false);
    json_end(&json, file);
    rewind(file);
    assert_non_null(fgets(got, sizeof got, file));
    assert_string_equal(got, "{\"at\": \"a \\\"path\\\" \\\\ of\\u0009tabs\\n\", \"x\": 0.1, \"no\": null, "
                             "\"endless\": null, \"clock\": 1234567.000001, \"n\": 18446744073709551615, "
                             "\"done\": false}\n");
    assert_null(fgets(got, sizeof got, file));
    fclose(file);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lines),
        cmocka_unit_test(test_lines_read),
        cmocka_unit_test(test_json),
    };
    return cmocka_run_group_tests(tests, support_folder, support_clean);
}
