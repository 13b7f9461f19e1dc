/* What `make install` puts into a folder renders from there, without the source tree and for any user, and
 * `make uninstall` takes it away again, and nothing else. */
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
    snprintf(whole, sizeof whole, "{ %s; } >'%s' 2>&1 </dev/null", command, support_path("said"));
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

/* A command in a folder with a blank in its name, which is `root` in the command. */
static void expect(const char *command) {
    char whole[1800];
    snprintf(whole, sizeof whole, "root='%s' && %s", root, command);
    expect_run(whole);
}

/* By make, which must build nothing: the program is there, and this make may not know with which compiler it
 * was built. `what` is install or uninstall. A careful user's umask must not count. */
static void make(const char *what) {
    char command[1200];
    const char *program = getenv("MAGICHOUR");
    bool sanitized = program && strstr(program, "/asan/");
    snprintf(command, sizeof command,
             "umask 077; env -u MAKEFLAGS -u MFLAGS -u MAKELEVEL make -s -o all -o build%s/magichour %s "
             "DESTDIR=\"$root\" PREFIX='/opt/a b'%s",
             sanitized ? "/asan" : "", what, sanitized ? " MODE=asan" : "");
    expect(command);
}

/* Two files of others and an empty folder in the folders that are shared. */
static int make_root(void **state) {
    if (support_folder(state) != 0) return -1;
    snprintf(root, sizeof root, "%s", support_path("the root"));
    expect("mkdir -p \"$root/opt/a b/bin\" \"$root/opt/a b/share/man/man1\" "
           "\"$root/opt/a b/share/man/man5\"");
    expect("touch \"$root/opt/a b/bin/other\" \"$root/opt/a b/share/man/man1/other.1\"");
    expect("chmod -R a+rX \"$root/..\" && find \"$root\" | sort >\"$root.before\"");
    return 0;
}

static int remove_root(void **state) {
    expect("rm -r \"$root\"");
    return support_clean(state);
}

static void expect_nothing_left(void) {
    expect("find \"$root\" | sort | diff \"$root.before\" -");
}

/* The picture is made by the user `nobody` where the test may become that. */
static void render_from_anywhere(void) {
    char command[1600];
    Image image;
    Error error;
    const char *picture = support_path("picture.pfm");
    snprintf(
        command, sizeof command,
        "root='%s' && cd / && touch '%s' && chmod 666 '%s' && "
        "if [ $(id -u) = 0 ]; then become='setpriv --reuid=65534 --regid=65534 --clear-groups'; fi && "
        "$become env HOME=/nonexistent \"$root/opt/a b/bin/magichour\" render crater --size 16x16 --spp 4 "
        "--quiet -o - --format pfm >'%s'",
        root, picture, picture, picture);
    int status = run(command);
    if (WEXITSTATUS(status) == STATUS_NO_GL) support_no_gl("the installed program finds none");
    if (status) expect_run(command);
    if (!image_read(&image, picture, &error)) fail_msg("%s", error.text);
    double sum = 0;
    for (int i = 0; i < 4 * 16 * 16; i++) sum += (double)image.rgba[i];
    assert_true(isfinite(sum) && sum > 4 * 16 * 16 / 4);
    image_free(&image);
}

static void test_install(void **state) {
    (void)state;
    make("install");
    expect("test -z \"$(find \"$root\" -not -perm -o=r -o -type d -not -perm -o=x)\"");
    expect("test -z \"$(find \"$root\" -perm -o=w)\"");
    expect("cd \"$root/opt/a b/share\" && test -s man/man1/magichour.1 && "
           "bash -n bash-completion/completions/magichour && test -s zsh/site-functions/_magichour && "
           "test -s fish/vendor_completions.d/magichour.fish && test -s doc/magichour/LICENSE && "
           "test -s bash-completion/completions/magichour && test -s zsh/site-functions/_magichour && "
           "test -s fish/vendor_completions.d/magichour.fish && "
           "test ! -e magichour/scenes/gallery");
    make("uninstall");
    expect_nothing_left();
}

static void test_render(void **state) {
    (void)state;
    make("install");
    render_from_anywhere();
    make("uninstall");
    expect_nothing_left();
}

/* A file of an older version goes when a newer one is installed, and the user's own files stay. */
static void test_install_again(void **state) {
    (void)state;
    make("install");
    expect("cd \"$root/opt/a b/share/magichour\" && touch scenes/old.glsl scenes/own.glsl && "
           "echo share/magichour/scenes/old.glsl >>installed");
    make("install");
    expect("cd \"$root/opt/a b/share/magichour\" && test ! -e scenes/old.glsl && test -e scenes/own.glsl");
    make("uninstall");
    expect("cd \"$root/opt/a b/share/magichour\" && test \"$(find . -type f)\" = ./scenes/own.glsl && "
           "rm -r \"$root/opt/a b/share/magichour\"");
    expect_nothing_left();
    make("uninstall");
    expect_nothing_left();
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_install),
        cmocka_unit_test(test_render),
        cmocka_unit_test(test_install_again),
    };
    return cmocka_run_group_tests_name("install", tests, make_root, remove_root);
}
