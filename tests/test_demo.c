/* tools/demo.sh with a program in place of magichour that only notes what it is asked for; and what a build
 * without its window asks the system for. */
#include "support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

static char said[16384];

/* Runs a shell command, in which $folder is the test's, and gives its exit status; what it said is in `said`.
 */
static int run(const char *command) {
    char whole[2048];
    snprintf(whole, sizeof whole, "folder='%s' && { %s; } >'%s' 2>&1 </dev/null", support_path("."), command,
             support_path("said"));
    int status = system(whole);
    FILE *file = fopen(support_path("said"), "r");
    assert_non_null(file);
    said[fread(said, 1, sizeof said - 1, file)] = 0;
    fclose(file);
    return WEXITSTATUS(status);
}

static void expect_said(const char *words) {
    if (!strstr(said, words)) fail_msg("no '%s' in: %s", words, said);
}

static int count_said(const char *words) {
    int count = 0;
    for (const char *at = said; (at = strstr(at, words)); at++) count++;
    return count;
}

/* It says how many pictures there are, what each shows and what to try next. An error that is not promised
 * ends nothing. */
static void test_demo(void **state) {
    (void)state;
    support_write("program", "#!/bin/sh\necho \"asked: $*\"\ntest -s \"$2\" || exit 3\n"
                             "case $* in *rayleigh=0*) exit 7 ;; esac\n");
    assert_int_equal(
        run("chmod +x \"$folder/program\" && tools/demo.sh \"$folder/program\" \"$folder\" --size 8x8"), 0);
    int pictures = count_said("asked: render ");
    assert_true(pictures >= 10);
    assert_int_equal(count_said("--error 1levels"), pictures);
    assert_int_equal(count_said("--size 8x8"), pictures);
    char words[64];
    snprintf(words, sizeof words, "%d pictures, each as EXR and as PNG, go into ", pictures);
    expect_said(words);
    snprintf(words, sizeof words, "%d of %d, ", pictures, pictures);
    expect_said(words);
    expect_said("What to try next:");
    expect_said(" view crater ");
    expect_said(" render valley -o ");
    expect_said(" view my.glsl ");
}

static void test_failure(void **state) {
    (void)state;
    support_write("program", "#!/bin/sh\nexit 4\n");
    assert_int_equal(run("chmod +x \"$folder/program\" && tools/demo.sh \"$folder/program\" \"$folder\""), 4);
    assert_null(strstr(said, "What to try next:"));
}

/* Which groups of tools/deps.sh the Makefile names. */
static void test_needs(void **state) {
    (void)state;
    assert_int_equal(run("env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL -u WINDOW make -n deps"), 0);
    expect_said(" window ");
    expect_said(" window-test ");
    assert_int_equal(run("env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -n WINDOW=0 deps test"), 0);
    expect_said("tools/deps.sh build ");
    assert_null(strstr(said, "deps.sh build window"));
    assert_null(strstr(said, "window-test"));
    assert_int_equal(run("tools/deps.sh build frob"), 2);
    expect_said("deps: unknown group 'frob' (known: build window ");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_demo),
        cmocka_unit_test(test_failure),
        cmocka_unit_test(test_needs),
    };
    return cmocka_run_group_tests_name("demo", tests, support_folder, support_clean);
}
