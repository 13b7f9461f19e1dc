/* A scene is found by its name from any folder, and a folder's scenes are listed with their titles. */
#include "support.h"

#include "cmd/scene_find.h"
#include "scene/scene_list.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define SCENE "void scene_intersect(Ray ray, INOUT(Hit) hit) {}\n"

/* Folders as an installed program has them: a library, and scenes beside it. */
static char library[600];

static int make_folders(void **state) {
    if (support_folder(state) != 0) return -1;
    if (mkdir(support_path("share"), 0777) != 0 || mkdir(support_path("share/glsl"), 0777) != 0 ||
        mkdir(support_path("share/scenes"), 0777) != 0 ||
        mkdir(support_path("share/scenes/d.glsl"), 0777) != 0)
        return -1;
    snprintf(library, sizeof library, "%s", support_path("share/glsl"));
    support_write("share/scenes/moon.glsl", "//@ title The moon\n" SCENE);
    support_write("share/scenes/toy.glsl",
                  "void mainImage(out vec4 color, in vec2 place) { color = vec4(1.0); }\n");
    support_write("share/scenes/faulty.glsl", "//@ title Has a fault\n//@ no-such-key\n" SCENE);
    support_write("share/scenes/shapes.glsl", "float shape(vec3 p) { return p.x; }\n");
    support_write("share/scenes/notes.txt", "//@ title Notes\n" SCENE);
    support_write("share/scenes/.hidden.glsl", "//@ title Hidden\n" SCENE);
    return 0;
}

static int remove_folders(void **state) {
    char command[700];
    snprintf(command, sizeof command, "rm -r '%s'", support_path("share"));
    return system(command) == 0 ? support_clean(state) : -1;
}

static void test_list(void **state) {
    (void)state;
    static const char *const expected[][2] = {{"faulty", "Has a fault"}, {"moon", "The moon"}, {"toy", ""}};
    char *folder = scene_list_folder(library);
    SceneList list = scene_list_read(folder);
    assert_int_equal(list.count, 3);
    for (int i = 0; i < list.count; i++) {
        assert_string_equal(list.entries[i].name, expected[i][0]);
        assert_string_equal(list.entries[i].title, expected[i][1]);
        assert_int_equal(access(list.entries[i].path, R_OK), 0);
    }
    scene_list_free(&list);
    free(folder);
    list = scene_list_read(support_path("no-such-folder"));
    assert_int_equal(list.count, 0);
}

/* The folder is beside the library itself, also where a link leads to it. */
static void test_folder(void **state) {
    (void)state;
    char *folder = scene_list_folder(library);
    assert_string_equal(folder + strlen(folder) - strlen("share/scenes"), "share/scenes");
    assert_int_equal(symlink(library, support_path("link")), 0);
    char *by_link = scene_list_folder(support_path("link"));
    assert_string_equal(by_link, folder);
    free(by_link);
    free(folder);
    folder = scene_list_folder("no-such-folder/glsl");
    assert_string_equal(folder, "no-such-folder/scenes");
    free(folder);
    folder = scene_list_folder("no-such-folder");
    assert_string_equal(folder, "scenes");
    free(folder);
}

static void expect_path(const char *word, const char *end) {
    char *path;
    Error error;
    if (!scene_find(word, library, &path, &error)) fail_msg("%s", error.text);
    size_t length = strlen(path), least = strlen(end);
    if (length < least || strcmp(path + length - least, end) != 0)
        fail_msg("'%s' is found as %s", word, path);
    free(path);
}

static void expect_refused(const char *word, const char *said) {
    char *path;
    Error error;
    assert_false(scene_find(word, library, &path, &error));
    assert_int_equal(error.status, STATUS_SCENE);
    if (!strstr(error.text, said)) fail_msg("'%s': no '%s' in: %s", word, said, error.text);
}

static void test_find(void **state) {
    (void)state;
    char here[600];
    assert_non_null(getcwd(here, sizeof here));
    assert_int_equal(chdir(support_path("")), 0);
    expect_path("moon", "/share/scenes/moon.glsl");
    assert_int_equal(mkdir("moon", 0777), 0);
    expect_path("moon", "/share/scenes/moon.glsl");
    assert_int_equal(rmdir("moon"), 0);
    support_write("moon", SCENE);
    expect_path("moon", "moon");
    assert_int_equal(unlink("moon"), 0);
    /* What is there, and what is wrong with it, is said where the file is opened. */
    expect_path("share", "share");
    expect_path("share/scenes/moon.glsl/more", "share/scenes/moon.glsl/more");
    expect_refused("mon", "share/scenes has no scene of this name: did you mean moon?");
    expect_refused("sun", "share/scenes has no scene of this name (`magichour info` lists the scenes)");
    expect_refused(
        "moon.glsl",
        "moon.glsl: cannot be read: No such file or directory: did you mean the installed scene moon?");
    expect_refused("scenes/mooon.glsl", "directory: did you mean the installed scene moon?");
    expect_refused("../moon", "did you mean the installed scene moon?");
    expect_refused("", ": cannot be read: No such file or directory");
    assert_int_equal(chdir(here), 0);
}

/* Every command that takes a scene. The window's is in test_window.c, and a picture is in test_install.c. */
static void test_commands(void **state) {
    (void)state;
    static const char *const commands[] = {"render moonn -o a.png", "flatten moonn", "info moonn",
                                           "chart moonn -o charts", "explain moonn"};
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
        support_expect(3, "moonn: cannot be read: No such file or directory, and ", "%s", commands[i]);
    assert_int_equal(support_run("cd / &&", "info gyroid"), 0);
    assert_non_null(strstr(support_out, "/scenes/gyroid.glsl: Gyroid\n"));
    assert_int_equal(support_run("cd / &&", "flatten gyroid"), 0);
    assert_int_equal(support_run("cd / &&", "info --backend auto"), 0);
    assert_non_null(strstr(support_out, "\n  gyroid       Gyroid\n"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_list),
        cmocka_unit_test(test_folder),
        cmocka_unit_test(test_find),
        cmocka_unit_test(test_commands),
    };
    return cmocka_run_group_tests_name("scene_find", tests, make_folders, remove_folders);
}
