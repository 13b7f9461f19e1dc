/* The window's panel, its list of keys and its hint for a first run, by real events. */
#include "desktop.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define CRATER "\"$here\"/scenes/crater.glsl --size 800x500 --sky uniform"

static double brightness(int x, int y, int width, int height) {
    double rgb[3];
    desktop_mean(window, x, y, width, height, rgb);
    return (rgb[0] + rgb[1] + rgb[2]) / 3;
}

/* Where nothing can be remembered the window works as well. */
static void test_no_memory(void **state) {
    (void)state;
    const char *path = support_write("state", "a file where a folder should be");
    desktop_view(window, CRATER);
    desktop_do(window, "key n");
    desktop_expect_number(window, "panel", 1, 1);
    desktop_quit(window);
    unlink(path);
}

/* The hint stays while the pointer moves, goes with the first key, and never comes again. The panel is a bar
 * at first in a window of this size, and is found where it was left. */
static void test_memory(void **state) {
    (void)state;
    desktop_view(window, CRATER);
    desktop_settle(window);
    assert_true(desktop_number(window, "hint") == 0); /* desktop_settle() presses a key */
    assert_true(desktop_number(window, "panel") == 0);
    assert_int_equal(access(support_path("state/magichour/window.ini"), F_OK), 0);
    assert_true(brightness(420, 60, 200, 200) > 100);
    desktop_do(window, "key n");
    desktop_expect_number(window, "panel", 1, 1);
    desktop_settle(window);
    assert_true(brightness(20, 60, 200, 200) < 60);
    desktop_do(window, "mousemove 100 16");
    desktop_settle(window);
    desktop_also(window, "mousedown 1");
    desktop_settle(window);
    desktop_also(window, "mousemove 500 26");
    desktop_settle(window);
    desktop_also(window, "mouseup 1");
    desktop_settle(window);
    assert_true(brightness(20, 60, 200, 200) > 100 && brightness(420, 70, 200, 200) < 60);
    assert_true(desktop_number(window, "eye_x") == 0 && desktop_number(window, "eye_z") == -4);
    desktop_quit(window);
    desktop_view(window, CRATER);
    assert_true(desktop_largest(window, "hint") == 0);
    desktop_settle(window);
    assert_true(desktop_number(window, "panel") == 1);
    assert_true(brightness(20, 60, 200, 200) > 100 && brightness(420, 70, 200, 200) < 60);
    desktop_do(window, "key n");
    desktop_expect_number(window, "panel", 0, 0);
    desktop_settle(window);
    assert_true(brightness(420, 70, 200, 200) > 100);
    desktop_quit(window);
}

static void test_hint(void **state) {
    (void)state;
    unlink(support_path("state/magichour/window.ini"));
    desktop_view(window, CRATER);
    desktop_do(window, "mousemove 300 200 mousemove 310 200");
    desktop_expect(window, "\"event\": \"frame\"", "\"hint\": 1");
    desktop_expect_number(window, "seconds", 0.5, 1e9);
    assert_true(desktop_number(window, "hint") == 1);
    assert_true(brightness(120, 445, 400, 40) < 60);
    assert_int_not_equal(access(support_path("state/magichour/window.ini"), F_OK), 0);
    desktop_do(window, "click 2");
    desktop_expect_number(window, "hint", 0, 0);
    desktop_settle(window);
    assert_true(brightness(120, 445, 400, 40) > 60);
    desktop_quit(window);
}

/* The list of keys is over the picture, takes the mouse, and Escape closes it and not the window. */
static void test_help(void **state) {
    (void)state;
    desktop_view(window, CRATER);
    desktop_settle(window);
    double before = brightness(150, 100, 500, 300);
    desktop_do(window, "key question");
    desktop_expect_number(window, "help", 1, 1);
    desktop_settle(window);
    assert_true(brightness(150, 100, 500, 300) < 0.5 * before);
    desktop_do(window, "mousemove 400 300 mousedown 1 mousemove 500 300 mouseup 1");
    desktop_settle(window);
    assert_true(desktop_number(window, "eye_x") == 0);
    desktop_do(window, "key Escape");
    desktop_expect_number(window, "help", 0, 0);
    desktop_do(window, "key F1");
    desktop_expect_number(window, "help", 1, 1);
    desktop_do(window, "key F1");
    desktop_expect_number(window, "help", 0, 0);
    desktop_settle(window);
    assert_true(brightness(150, 100, 500, 300) > 0.9 * before);
    desktop_quit(window);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_no_memory, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_memory, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_hint, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_help, desktop_setup, desktop_teardown),
    };
    return cmocka_run_group_tests_name("window_panel", tests, support_folder, support_clean);
}
