/* tools/ci/renders.sh, as a repository of scenes uses it: pictures that are equal pass, and a changed scene
 * fails and leaves pictures of the difference. */
#include "support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* The program's absolute path: the script runs in the folder of the pictures. */
static char program[1024];

/* Runs a shell command in the copy of the example and gives its exit status; what it said is in `said`. */
static char said[8192];
static int run(const char *command) {
    char whole[4096];
    snprintf(whole, sizeof whole,
             "tools=$PWD/tools/ci && export MAGICHOUR='%s' && cd '%s' && { %s; } >../said 2>&1 </dev/null",
             program, support_path("example"), command);
    int status = system(whole);
    FILE *file = fopen(support_path("said"), "r");
    assert_non_null(file);
    said[fread(said, 1, sizeof said - 1, file)] = 0;
    fclose(file);
    return WEXITSTATUS(status);
}

static void expect(int status, const char *words, const char *command) {
    int got = run(command);
    if (got != status || !strstr(said, words))
        fail_msg("%s: expected status %d and '%s', got %d and: %s", command, status, words, got, said);
}

static int copy_example(void **state) {
    char command[2048];
    const char *named = getenv("MAGICHOUR");
    if (support_folder(state) != 0 || !realpath(named ? named : "build/magichour", program)) return -1;
    snprintf(command, sizeof command, "cp -r tools/ci/example '%s'", support_path("example"));
    return system(command);
}

static int remove_example(void **state) {
    char command[2048];
    snprintf(command, sizeof command, "rm -r '%s'", support_path("example"));
    return system(command) == 0 ? support_clean(state) : -1;
}

static void test_renders(void **state) {
    (void)state;
    if (run("\"$tools/renders.sh\" store") == STATUS_NO_GL) support_no_gl(said);
    expect(0, "stored/evening.exr", "\"$tools/renders.sh\" store");
    expect(0, "noon: equal within", "\"$tools/renders.sh\" check");
    expect(0, "", "test -z \"$(ls out)\"");

    /* A deliberate change of the scene, and the pictures that show it. */
    expect(0, "", "sed -i 's/0\\.8, 0\\.2, 0\\.1/0.7, 0.2, 0.1/' scenes/ball.glsl");
    expect(STATUS_COMPARISON, "noon: DIFFERS: relRMSE ", "\"$tools/renders.sh\" check");
    expect(0, "relRMSE ", "cat out/noon.txt");
    Image image;
    Error error;
    if (!image_read(&image, support_path("example/out/noon.png"), &error)) fail_msg("%s", error.text);
    assert_true(image.width > 3 * 128);
    image_free(&image);

    /* The same picture by other random numbers is another one: its noise differs. */
    expect(0, "", "\"$tools/renders.sh\" store && \"$tools/renders.sh\" check && test -z \"$(ls out)\"");
    expect(STATUS_COMPARISON, "DIFFERS", "\"$tools/renders.sh\" check --seed 1");
}

static void test_faults(void **state) {
    (void)state;
    if (run("\"$tools/renders.sh\" store") == STATUS_NO_GL) support_no_gl(said);
    expect(1, "noon: MISSING: stored/noon.exr", "rm stored/noon.exr && \"$tools/renders.sh\" check");
    expect(0, "", "test -s out/noon.exr");
    expect(STATUS_SCENE, "noon: NOT RENDERED: exit status 3",
           "echo wrong >>scenes/ball.glsl; \"$tools/renders.sh\" check");
    expect(2, "no pictures.txt in ", "cd scenes && \"$tools/renders.sh\" check");
    expect(2, "renders.sh check|store", "\"$tools/renders.sh\" chekc");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_renders, copy_example, remove_example),
        cmocka_unit_test_setup_teardown(test_faults, copy_example, remove_example),
    };
    return cmocka_run_group_tests_name("ci", tests, NULL, NULL);
}
