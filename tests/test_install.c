/* What `make install` puts into a folder renders from there, without the source tree. */
#include "support.h"

#include "image/format.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

static char root[600];

static int run(const char *command) {
    char whole[2048];
    snprintf(whole, sizeof whole, "%s >'%s' 2>&1 </dev/null", command, support_path("said"));
    return system(whole);
}

static void expect_run(const char *command) {
    if (run(command) == 0) return;
    char said[2000] = "";
    FILE *file = fopen(support_path("said"), "r");
    if (file) said[fread(said, 1, sizeof said - 1, file)] = 0;
    if (file) fclose(file);
    fail_msg("%s: %s", command, said);
}

/* By make, which must build nothing: the program is there, and this make may not know with which compiler it
 * was built. `what` is install or uninstall. */
static void make(const char *what) {
    char command[2000];
    const char *program = getenv("MAGICHOUR");
    bool sanitized = program && strstr(program, "/asan/");
    snprintf(command, sizeof command,
             "env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -s -o all -o build%s/magichour %s DESTDIR='%s' "
             "PREFIX=/opt/a%s",
             sanitized ? "/asan" : "", what, root, sanitized ? " MODE=asan" : "");
    expect_run(command);
}

static void test_install(void **state) {
    (void)state;
    char command[2000];
    Image image;
    Error error;
    snprintf(root, sizeof root, "%s", support_path("root"));
    make("install");
    snprintf(command, sizeof command,
             "cd / && '%s/opt/a/bin/magichour' render crater --size 16x16 --spp 4 --quiet -o '%s'", root,
             support_path("picture.pfm"));
    int status = run(command);
    if (WEXITSTATUS(status) == STATUS_NO_GL) support_no_gl("the installed program finds none");
    if (status) expect_run(command);
    if (!image_read(&image, support_path("picture.pfm"), &error)) fail_msg("%s", error.text);
    double sum = 0;
    for (int i = 0; i < 4 * 16 * 16; i++) sum += (double)image.rgba[i];
    assert_true(isfinite(sum) && sum > 4 * 16 * 16 / 4);
    image_free(&image);
    snprintf(command, sizeof command, "test -s '%s/opt/a/share/man/man1/magichour.1'", root);
    expect_run(command);
    make("uninstall");
    snprintf(command, sizeof command, "test -z \"$(find '%s' -type f)\"", root);
    expect_run(command);
    snprintf(command, sizeof command, "rm -r '%s'", root);
    expect_run(command);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_install)};
    return cmocka_run_group_tests_name("install", tests, support_folder, support_clean);
}
