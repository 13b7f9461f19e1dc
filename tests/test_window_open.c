/* Other scenes opened in the window, by real events. */
#include "desktop.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define PLANE(title, color)                                                                                  \
    "//@ title " title "\n//@ camera eye 0 3 -3 target 0 0 0\n#include \"material/matte.glsl\"\n"            \
    "#include \"shape/plane.glsl\"\nuniform float k; //@ slider 1 min 0 max 1\n"                             \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit); }\n"  \
    "Material scene_material(Hit hit) { return matte(k * " color "); }\n"

static const char red[] = PLANE("Red", "vec3(0.8, 0.1, 0.1)"), blue[] = PLANE("Blue", "vec3(0.1, 0.1, 0.8)"),
                  toy[] =
                      "void mainImage(out vec4 color, in vec2 at) { color = vec4(0.0, 1.0, 0.0, 1.0); }\n";

static double redness(void) {
    double rgb[3];
    desktop_mean(window, 340, 300, 200, 60, rgb);
    return rgb[0] / (rgb[2] + 1);
}

/* A dropped scene is shown as its file has it, without the command line's settings, and is the one that is
 * watched from then on. What is no scene changes nothing. */
static void test_drop(void **state) {
    (void)state;
    const char *first = support_write("red.glsl", red), *second = support_write("blue.glsl", blue);
    desktop_view(window, "'%s' --size 640x400 --sky uniform --set k=0.5 --sun 50", first);
    desktop_expect_rest(window, 16);
    assert_true(redness() > 2);
    desktop_drop(window, "Red", second);
    desktop_expect(window, "\"event\": \"open\"", "\"message\": \"\"");
    desktop_expect_rest(window, 16);
    assert_true(redness() < 0.5);
    assert_true(desktop_number(window, "elevation") == 30);
    desktop_drop(window, "Blue", support_write("none.glsl", "no scene"));
    desktop_expect(window, "\"event\": \"open\"", "none.glsl");
    desktop_settle(window);
    assert_true(redness() < 0.5);
    desktop_do(window, "mousemove 600 300");
    support_write("red.glsl", "broken");
    support_write("blue.glsl", red);
    desktop_expect(window, "\"event\": \"reload\"", "\"result\": \"good\"");
    desktop_expect_rest(window, 16);
    assert_true(redness() > 2);
    desktop_drop(window, "Red", support_write("toy.glsl", toy));
    desktop_expect(window, "\"event\": \"open\"", "\"message\": \"\"");
    desktop_expect_samples(window, 3);
    double rgb[3];
    desktop_mean(window, 340, 300, 200, 60, rgb);
    assert_true(rgb[1] > 250 && rgb[0] < 5);
    support_write("blue.glsl", blue);
    desktop_drop(window, "toy", second);
    desktop_expect_rest(window, 16);
    assert_true(redness() < 0.5);
    desktop_quit(window);
}

static void click(int x, int y) {
    desktop_do(window, "mousemove %d %d", x, y);
    desktop_settle(window);
    desktop_also(window, "mousedown 1");
    desktop_settle(window);
    desktop_also(window, "mouseup 1");
    desktop_settle(window);
}

/* The panel lists the scenes beside the open one, by name. A row of the panel is 17 pixels high, or 23 if it
 * has a frame, and the scene's slider is the fourth of all. */
static void test_list(void **state) {
    (void)state;
    static const int grab[3] = {191, 143, 51};
    int x, y = 0;
    support_write("blue.glsl", blue);
    support_write("part.glsl", "float part() { return 1.0; }\n");
    desktop_view(window, "'%s' --size 640x540 --sky uniform", support_write("red.glsl", red));
    desktop_do(window, "key n");
    desktop_expect_number(window, "panel", 1, 1);
    desktop_settle(window);
    for (int i = 0; i < 4; i++) assert_true(desktop_find(window, grab, i ? y + 16 : 0, &x, &y));
    click(60, y + 6 + 3 * 23);
    click(60, y + 6 + 3 * 23 + 37);
    desktop_expect(window, "\"event\": \"open\"", "/blue.glsl");
    desktop_expect_rest(window, 16);
    assert_true(redness() < 0.5);
    desktop_quit(window);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_drop, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_list, desktop_setup, desktop_teardown),
    };
    return cmocka_run_group_tests_name("window_open", tests, support_folder, support_clean);
}
