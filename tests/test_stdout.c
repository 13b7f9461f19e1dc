/* Pictures that go to standard output: nothing but the picture is in the stream, whatever it is called. */
#include "support.h"
#include "terminal.h"

#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TINY "render scenes/crater.glsl --size 16x16 --spp 1 --sky uniform"

/* Runs a line of a shell in which $M is the program and $D the folder; gives its exit status. */
static int shell(const char *line) {
    const char *program = getenv("MAGICHOUR");
    setenv("M", program ? program : "build/magichour", 1);
    setenv("D", support_path(""), 1);
    int status = system(line);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

static void expect(int status, const char *line) {
    int got = shell(line);
    if (got != status) fail_msg("%s: status %d, not %d", line, got, status);
}

static void expect_said(const char *words) {
    Text text = {0};
    Error error;
    assert_true(file_read(support_path("said"), STATUS_FAILURE, &text, &error));
    if (!strstr(text_string(&text), words)) fail_msg("no '%s' in: %s", words, text_string(&text));
    text_free(&text);
}

/* Each way to standard output, into a file and into a pipe, gives the bytes of the file that is written by
 * its name. The summary is on standard error, with or without a picture beside it. */
static void test_names(void **state) {
    (void)state;
    static const char *const names[] = {"-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"};
    char line[512];
    expect(0, "$M " TINY " -o $D/true.pfm >/dev/null");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        snprintf(line, sizeof line,
                 "$M " TINY " -o %s --format pfm >$D/out 2>$D/said && cmp $D/out $D/true.pfm", names[i]);
        expect(0, line);
        expect_said("Mpaths/s");
        snprintf(line, sizeof line, "$M " TINY " -v -o %s --format pfm 2>$D/said | cmp - $D/true.pfm",
                 names[i]);
        expect(0, line);
        expect_said("Mpaths/s");
    }
    /* What a file held stays in front of what is appended to it. */
    expect(0, "printf head >$D/out; $M " TINY " -o - --format pfm >>$D/out 2>/dev/null;"
              "printf head | cat - $D/true.pfm | cmp - $D/out");
    /* A file that the shell opened under another number, and a program that is one (a named pipe). */
    expect(0, "$M " TINY " -o /dev/fd/7 --format pfm 7>$D/out >/dev/null; cmp $D/out $D/true.pfm");
    expect(0, "mkfifo $D/pipe; cat $D/pipe >$D/out & $M " TINY " -o $D/pipe --format pfm >/dev/null; wait;"
              "cmp $D/out $D/true.pfm");
    /* Without standard error, what is printed is lost, and the picture is whole. */
    expect(0, "$M " TINY " -o - --format pfm 2>&- | cmp - $D/true.pfm");
}

/* --format names the format of what has no ending; a single -o has it whatever its ending. */
static void test_format(void **state) {
    (void)state;
    expect(0, "$M " TINY " -o - --format exr 2>/dev/null | head -c 4 | od -An -tx1 | grep -q '76 2f 31 01'");
    expect(0, "$M " TINY " -o - --format png 2>/dev/null | head -c 4 | od -An -tx1 | grep -q '89 50 4e 47'");
    expect(0, "$M " TINY " -o $D/a.data --format pfm --quiet && head -c 2 $D/a.data | grep -q PF");
    expect(0, "$M " TINY " -o $D/a.png --format pfm --quiet && head -c 2 $D/a.png | grep -q PF");
    expect(0, "$M " TINY " -o - -o $D/b.pfm --format png 2>/dev/null | head -c 4 | grep -q PNG &&"
              "head -c 2 $D/b.pfm | grep -q PF");
    expect(0, "$M " TINY " -o $D/plain --aov albedo --format exr --quiet && grep -q albedo.R $D/plain");
    support_expect(2, "only .exr holds layers", TINY " --aov albedo -o - --format png");
    support_expect(2, "-: no ending names the format", TINY " -o -");
    support_expect(2, "unknown 'jpg' (known: exr, png, pfm)", TINY " -o - --format jpg");
    support_expect(2, "standard output is named 2 times", TINY " -o - -o /dev/stdout --format png");
    support_expect(2, "--format is for maps", "sky --at rows.csv --format exr");
}

static void test_refused(void **state) {
    (void)state;
    expect(5, "$M " TINY " -o - --format png >&- 2>$D/said");
    expect_said("standard output: cannot be written: Bad file descriptor");
    expect(5, "$M " TINY " -o - --format png >/dev/full 2>$D/said");
    expect_said("standard output: cannot be written: No space left");
    expect(5, "$M help >/dev/full 2>$D/said");
    expect_said("standard output: cannot be written: No space left");
    expect(5, "$M flatten scenes/crater.glsl >/dev/full 2>$D/said");
    expect_said("standard output: cannot be written: No space left");
    expect(5, "$M " TINY " -o /dev/fd/9 --format png 2>$D/said");
    expect_said("/dev/fd/9: cannot be written: Bad file descriptor");
    expect(5, "$M " TINY " -o /dev/fd/9 --format png 9</dev/null 2>$D/said");
}

/* A terminal of the test's own, as standard output and by its name. */
static void test_terminal(void **state) {
    (void)state;
    Terminal terminal;
    char line[512];
    terminal_open(&terminal, 80);
    const char *name = terminal.name;
    assert_true(file_is_terminal(name));
    assert_false(file_is_terminal("/dev/null"));
    snprintf(line, sizeof line, "$M " TINY " -o - --format png >%s 2>$D/said", name);
    expect(2, line);
    expect_said("this is a terminal");
    snprintf(line, sizeof line, "$M " TINY " -o %s 2>$D/said", name);
    expect(2, line);
    expect_said("this is a terminal");
    terminal_close(&terminal);
}

/* A map, listed rows, and pictures of a difference; and a picture that is read from standard input, with its
 * metadata. */
static void test_other_commands(void **state) {
    (void)state;
    expect(0, "$M sky --size 8x4 -o $D/map.pfm >/dev/null;"
              "$M sky --size 8x4 -o - --format pfm 2>/dev/null | cmp - $D/map.pfm");
    support_write("rows.csv", "0,30,20,0\n");
    expect(0, "$M sky --at $D/rows.csv -o $D/rows; $M sky --at $D/rows.csv >$D/out; cmp $D/out $D/rows;"
              "$M sky --at $D/rows.csv -o - | cmp - $D/rows");
    expect(0, "$M " TINY " -o $D/c.exr --quiet; $M " TINY " --seed 1 -o $D/d.exr --quiet");
    expect(0, "$M compare $D/c.exr $D/d.exr -o $D/c.png >$D/figures");
    expect(0, "$M compare $D/c.exr $D/d.exr -o - 2>$D/said | cmp - $D/c.png && cmp $D/said $D/figures");
    expect(0, "$M compare - $D/d.exr <$D/c.exr | cmp - $D/figures");
    expect(0, "cat $D/d.exr | $M compare $D/c.exr - | cmp - $D/figures");
    support_expect(2, "standard input holds one picture", "compare - - </dev/null");
    support_expect(1, "standard input: neither an EXR", "compare - '%s' </dev/null", support_path("c.exr"));
    support_expect(2, "false colours can only be written as .png", "compare a b -o c.exr");
    /* The sun's own pixels are named by metadata, which are read from the same bytes. */
    expect(0, "$M render scenes/crater.glsl --size 32x32 --spp 8 --sky uniform --sun 10 --sun-disk "
              "--set camera.target=0,3,0 -o $D/sun.exr --quiet;"
              "$M compare $D/sun.exr $D/sun.exr >$D/figures; $M compare - $D/sun.exr <$D/sun.exr |"
              "cmp - $D/figures && grep -q 'sun pixels   [1-9]' $D/figures");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_names),          cmocka_unit_test(test_format),
        cmocka_unit_test(test_refused),        cmocka_unit_test(test_terminal),
        cmocka_unit_test(test_other_commands),
    };
    return cmocka_run_group_tests_name("stdout", tests, support_folder, support_clean);
}
