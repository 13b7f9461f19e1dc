/* What long commands show while they work, on a terminal and elsewhere, and how they end at Ctrl-C: soon,
 * with what is done. */
#include "support.h"
#include "terminal.h"

#include "base/clock.h"
#include "base/file.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* The text of a file of the folder. */
static char *said(const char *name) {
    Text text = {0};
    Error error;
    if (!file_read(support_path(name), STATUS_FAILURE, &text, &error)) fail_msg("%s", error.text);
    text_append(&text, "", 0);
    return text.data;
}

static pid_t start_on(const char *arguments, const char *err) {
    char line[1024];
    const char *program = getenv("MAGICHOUR");
    snprintf(line, sizeof line, "exec '%s' %s >'%s' 2>'%s'", program ? program : "build/magichour", arguments,
             support_path("out"), err);
    pid_t child = fork();
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", line, (char *)NULL);
        _exit(127);
    }
    assert_true(child > 0);
    return child;
}

static pid_t start(const char *arguments) {
    return start_on(arguments, support_path("err"));
}

/* Waits until the program has said the words on standard error. */
static void await(const char *words, double seconds) {
    for (double end = clock_seconds() + seconds; clock_seconds() < end;) {
        char *text = access(support_path("err"), R_OK) == 0 ? said("err") : NULL;
        bool found = text && strstr(text, words);
        free(text);
        if (found) return;
        nanosleep(&(struct timespec){.tv_nsec = 20000000}, NULL);
    }
    fail_msg("'%s' was not said in %g s: %s", words, seconds, said("err"));
}

/* Starts a command that says JSON, interrupts it where it has said `at`, and gives the seconds until it ends,
 * with status 130. */
static double interrupt(const char *arguments, const char *at) {
    int status;
    unlink(support_path("err"));
    pid_t child = start(arguments);
    await(at, 120);
    double start_seconds = clock_seconds();
    kill(child, SIGINT);
    assert_int_equal(waitpid(child, &status, 0), child);
    double took = clock_seconds() - start_seconds;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 130)
        fail_msg("%s: status %x, not 130: %s", arguments, (unsigned)status, said("err"));
    print_message("%.50s: ended after %.2f s\n", arguments, took);
    return took;
}

/* Far less than what was left to do, and far more than it takes. */
static const double soon = 8;

static void expect_err(const char *part) {
    char *text = said("err");
    if (!strstr(text, part)) fail_msg("no '%s' in: %s", part, text);
    /* The interruption is said once, and not as an error besides. */
    assert_null(strstr(text, "interrupted while"));
    free(text);
}

static void need_gl(void) {
    Context context;
    support_open(&context);
    context_close(&context);
}

static void test_interrupted_sky(void **state) {
    (void)state;
    char line[512];
    need_gl();
    /* While tables are filled, which takes seconds for 6 bands of all orders, there is nothing to save. */
    snprintf(line, sizeof line, "sky --atmosphere earth --progress json -o '%s'", support_path("none.pfm"));
    assert_true(interrupt(line, "tables") < soon);
    assert_int_equal(access(support_path("none.pfm"), F_OK), -1);
    /* Between the rows: those that are done are kept, and the others are black. */
    snprintf(line, sizeof line, "sky --sky paper:400x40 --size 512x256 --progress json -o '%s'",
             support_path("part.pfm"));
    assert_true(interrupt(line, "\"share\": 0.") < soon);
    expect_err("of the map's 256 rows are written, and the others are black");
    Image image;
    Error error;
    if (!image_read(&image, support_path("part.pfm"), &error)) fail_msg("%s", error.text);
    assert_true(image.rgba[2] > 0 && image.rgba[4 * (256 * 512 - 1) + 2] <= 0);
    image_free(&image);
}

static void test_interrupted_rows(void **state) {
    (void)state;
    char line[512];
    Text rows = {0};
    need_gl();
    /* A table for each of the sun's places: so many that they take a while on any machine. */
    for (int i = 0; i < 9000; i++) text_print(&rows, "0,%.2f,20,0\n", 0.01 * i);
    snprintf(line, sizeof line, "sky --at '%s' --sky table:gauss --progress json",
             support_write("rows.csv", text_string(&rows)));
    text_free(&rows);
    assert_true(interrupt(line, "\"share\": 0.") < soon);
    expect_err("of 9000 rows are computed and written");
    char *kept = said("out");
    assert_true(strlen(kept) > 100);
    free(kept);
    snprintf(line, sizeof line, "sky --at '%s' --sky reference --atmosphere earth --progress json",
             support_path("rows.csv"));
    assert_true(interrupt(line, "all orders") < soon);
    char *text = said("out");
    assert_string_equal(text, "");
    free(text);
}

static void test_interrupted_measurements(void **state) {
    (void)state;
    char line[512];
    need_gl();
    assert_true(interrupt("explain scenes/arches.glsl --size 32x32 --progress json", "tables") < soon);
    assert_true(interrupt("explain scenes/crater.glsl --size 32x32 --progress json", "\"at\": \"ozone\"") <
                soon);
    expect_err("the rows so far are printed");
    char *text = said("out");
    assert_true(strstr(text, "Rayleigh scattering") && !strstr(text, "hits beyond the first"));
    free(text);
    snprintf(line, sizeof line, "chart scenes/arches.glsl --size 32x32 --progress json -o '%s'",
             support_path("chart"));
    assert_true(interrupt(line, "tables") < soon);
    snprintf(line, sizeof line, "chart scenes/crater.glsl --size 32x32 --time 20 --progress json -o '%s'",
             support_path("chart"));
    assert_true(interrupt(line, "\"share\": 0.2") < soon);
    expect_err("the same command goes on");
    snprintf(line, sizeof line, "rm -rf '%s'", support_path("chart"));
    assert_int_equal(system(line), 0);
}

/* Counts the places of some words. */
static int count(const char *text, const char *words) {
    int found = 0;
    for (; (text = strstr(text, words)); text += strlen(words)) found++;
    return found;
}

/* Away from a terminal there is a line each 5 seconds: none in a short run, and in a longer one as many as
 * fit. */
static void test_lines(void **state) {
    (void)state;
    char line[512];
    need_gl();
    support_expect(0, "", "render scenes/crater.glsl --size 16x16 --spp 1 --sky uniform -o '%s'",
                   support_path("a.exr"));
    assert_string_equal(support_err, "");
    support_expect(0, "", "render scenes/crater.glsl --size 64x64 --time 11.5 --sky uniform -o '%s'",
                   support_path("a.exr"));
    int lines = count(support_err, "samples, ");
    if (lines < 1 || lines > 2 || count(support_err, "magichour: ") < lines)
        fail_msg("%d lines: %s", lines, support_err);
    assert_null(strchr(support_err, '\r'));
    support_expect(0, "",
                   "render scenes/crater.glsl --size 64x64 --time 6 --sky uniform --progress none -o '%s'",
                   support_path("a.exr"));
    assert_null(strstr(support_err, "samples, "));
    support_expect(0, "", "render scenes/crater.glsl --size 64x64 --time 6 --sky uniform --quiet -o '%s'",
                   support_path("a.exr"));
    assert_null(strstr(support_err, "samples, "));
    snprintf(line, sizeof line, "sky --sky paper:800x80 --size 512x256 --progress lines -o '%s'",
             support_path("a.pfm"));
    unlink(support_path("err"));
    pid_t child = start(line);
    await(" s, map\n", 60);
    kill(child, SIGINT);
    waitpid(child, NULL, 0);
}

/* On a terminal there is one line, which is written over, keeps within the width, and is gone at the end. */
static void test_terminal(void **state) {
    (void)state;
    static const struct {
        const char *arguments, *words;
    } cases[] = {
        {"render scenes/crater.glsl --size 64x64 --time 1 --sky uniform -o /dev/null", "samples, "},
        {"sky --sky paper:100x20 --size 128x64 -o /dev/null", "map"},
        {"explain scenes/furnace.glsl --size 16x16", "the picture itself"},
    };
    need_gl();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        static char text[65536];
        Terminal terminal;
        terminal_open(&terminal, 40);
        char line[512];
        const char *program = getenv("MAGICHOUR");
        snprintf(line, sizeof line, "'%s' %s >/dev/null 2>%s && echo ENDED >%s &",
                 program ? program : "build/magichour", cases[i].arguments, terminal.name, terminal.name);
        assert_int_equal(system(line), 0);
        if (!terminal_await(&terminal, "ENDED\r\n", 120, text, sizeof text)) fail_msg("%s: %s", line, text);
        if (!strstr(text, cases[i].words)) fail_msg("no '%s' in %s", cases[i].words, text);
        assert_non_null(strstr(text, "\r\033[KENDED\r\n"));
        /* One line: nothing but the end and warnings goes to the next. */
        assert_true(strchr(text, '\n') > strstr(text, cases[i].words));
        for (char *part = strtok(text, "\r\n"); part; part = strtok(NULL, "\r\n")) {
            char *end = strstr(part, "\033[K");
            assert_true(!end || end - part < 40);
        }
        terminal_close(&terminal);
    }
}

/* A program that ends at once leaves no unfinished line in front of the shell's prompt. */
static void test_interrupted_line(void **state) {
    (void)state;
    static char text[16384];
    Terminal terminal;
    int status;
    need_gl();
    terminal_open(&terminal, 100);
    pid_t child = start_on("sky --atmosphere earth -o /dev/null", terminal.name);
    if (!terminal_await(&terminal, "tables", 60, text, sizeof text)) fail_msg("%s", text);
    kill(child, SIGINT);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 130);
    size_t length = terminal_read(&terminal, text, sizeof text);
    assert_true(length >= 4 && strcmp(text + length - 4, "\r\033[K") == 0);
    terminal_close(&terminal);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_interrupted_sky),
        cmocka_unit_test(test_interrupted_rows),
        cmocka_unit_test(test_interrupted_measurements),
        cmocka_unit_test(test_lines),
        cmocka_unit_test(test_terminal),
        cmocka_unit_test(test_interrupted_line),
    };
    return cmocka_run_group_tests_name("progress", tests, support_folder, support_clean);
}
