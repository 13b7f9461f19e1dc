/* The window, by real events on a display of its own: each step is checked on the log or on the screen's
 * pixels. */
#include "desktop.h"

#include "base/clock.h"
#include "base/file.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define SMALL "--size 320x180"

static double redness(int x, int y, int width, int height) {
    double rgb[3];
    desktop_mean(window, x, y, width, height, rgb);
    return rgb[0] / (rgb[2] + 1);
}

static double brightness(int x, int y, int width, int height) {
    double rgb[3];
    desktop_mean(window, x, y, width, height, rgb);
    return (rgb[0] + rgb[1] + rgb[2]) / 3;
}

/* Waits for what moves in the picture without starting it anew, and so without a word in the log. */
static bool darkens(int x, int y, int width, int height, double below) {
    double end = clock_seconds() + 20;
    while (brightness(x, y, width, height) >= below) {
        if (clock_seconds() > end) return false;
        usleep(50000);
    }
    return true;
}

/* 56 pixels of half a degree: 30 to 2 degrees. */
static void test_sun(void **state) {
    (void)state;
    desktop_view(window, "\"$here\"/scenes/crater.glsl " SMALL " --exposure 0");
    desktop_expect_rest(window, 16);
    desktop_do(window, "key h");
    desktop_settle(window);
    double noon = redness(100, 30, 120, 12);
    desktop_do(
        window,
        "mousemove 160 90 mousedown 3 mousemove 160 110 mousemove 160 130 mousemove 160 146 mouseup 3");
    desktop_expect_number(window, "elevation", 1.999, 2.001);
    desktop_expect_rest(window, 16);
    assert_true(redness(100, 30, 120, 12) > 1.5 * noon);
    desktop_do(window, "keydown s mousemove 160 100 mousedown 1 mousemove 180 90 mouseup 1 keyup s");
    desktop_expect_number(window, "elevation", 6.999, 7.001);
    desktop_expect_number(window, "azimuth", 349.99, 350.01);
    assert_true(desktop_number(window, "eye_z") == -4);
    desktop_do(window, "key Return key minus key 4 key Return");
    desktop_expect_number(window, "elevation", -4, -4);
    desktop_do(window, "key Return type --delay 12 '12.5, 90'");
    desktop_also(window, "key Return");
    desktop_expect_number(window, "elevation", 12.5, 12.5);
    desktop_expect_number(window, "azimuth", 90, 90);
    static const double elevations[] = {60, 30, 5, -2}, exposures[] = {0, 0, 0.5, 4};
    for (int i = 3; i >= 0; i--) {
        desktop_do(window, "key %d", i + 1);
        desktop_expect_number(window, "elevation", elevations[i], elevations[i]);
        assert_true(desktop_number(window, "exposure") == exposures[i]);
    }
    desktop_do(window, "key Up key Left key shift+Down");
    desktop_expect_number(window, "elevation", 60.8999, 60.9001);
    desktop_expect_number(window, "azimuth", 91, 91);
    desktop_quit(window);
}

static void test_day(void **state) {
    (void)state;
    desktop_view(window, "\"$here\"/scenes/crater.glsl " SMALL " --sun 10,0");
    desktop_do(window, "key period key period key t");
    desktop_expect_number(window, "elevation", 30, 60.0001);
    desktop_expect_number(window, "elevation", -18, 0);
    /* However few frames a slow machine draws, the sun never stood higher than at noon. */
    assert_true(desktop_largest(window, "elevation") < 60.0001);
    desktop_do(window, "key t");
    desktop_expect_rest(window, 16);
    desktop_quit(window);
}

/* A surface cannot reflect more than all light. The panel says so, and so does standard error, once. */
static void test_wrong_values(void **state) {
    (void)state;
    support_write(
        "wrong.glsl",
        "//@ camera eye 0 1 -4 target 0 0.5 0\n#include \"material/matte.glsl\"\n#include "
        "\"shape/sphere.glsl\"\n"
        "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_sphere(ray, vec3(0.0), 1.0, 4, hit); }\n"
        "Material scene_material(Hit hit) { return matte(vec3(2.0)); }\n");
    desktop_view(window, "wrong.glsl " SMALL);
    desktop_expect(
        window, "magichour: warning: wrong.glsl: object 4 has an albedo of 2; what is above 1 is taken as 1",
        "");
    desktop_expect_rest(window, 128);
    desktop_quit(window);
}

static void test_camera(void **state) {
    (void)state;
    desktop_view(window, "\"$here\"/scenes/crater.glsl " SMALL " --progress none --set ball=0");
    desktop_do(window, "key h");
    desktop_do(window, "mousemove 160 90 mousedown 1 mousemove 200 90 mousemove 205 80 mouseup 1");
    desktop_settle(window);
    desktop_expect_number(window, "eye_x", 2, 4.4);
    assert_true(fabs(hypot(hypot(desktop_number(window, "eye_x"), desktop_number(window, "eye_y")),
                           desktop_number(window, "eye_z")) -
                     sqrt(20)) < 1e-6);
    desktop_do(window, "click 4 click 4");
    desktop_expect_samples(window, 16);
    assert_true(fabs(hypot(hypot(desktop_number(window, "eye_x"), desktop_number(window, "eye_y")),
                           desktop_number(window, "eye_z")) -
                     0.81 * sqrt(20)) < 1e-6);
    double before = desktop_number(window, "eye_y");
    desktop_do(window, "keydown e");
    desktop_expect_number(window, "eye_y", before + 0.05, 100);
    desktop_do(window, "keyup e key r");
    desktop_expect_number(window, "eye_x", 0, 0);
    assert_true(desktop_number(window, "eye_y") == 2 && desktop_number(window, "eye_z") == -4);
    desktop_do(window, "key c");
    desktop_expect(window,
                   "//@ camera  eye 0 2 -4  target 0 0 0  fov 90\\n//@ sun     elevation 30  azimuth 0", "");
    desktop_quit(window);
}

/* A slider is known by its grab's colour, which it has below another's from some rows on. */
static void find_grab(int number, int *x, int *y) {
    static const int grab[3] = {191, 143, 51};
    *y = 0;
    for (int i = 0; i < number; i++) assert_true(desktop_find(window, grab, i ? *y + 16 : 0, x, y));
}

/* The overlay sees the pointer once a frame: each step waits until it is shown, the last one too, which opens
 * what a key may close. */
static void press_and_drag(int x, int y, int to_x, int to_y) {
    desktop_do(window, "mousemove %d %d", x, y);
    desktop_settle(window);
    desktop_also(window, "mousedown 1");
    desktop_settle(window);
    if (to_x != x || to_y != y) {
        desktop_also(window, "mousemove %d %d", to_x, to_y);
        desktop_settle(window);
    }
    desktop_also(window, "mouseup 1");
    desktop_settle(window);
}

#define PANEL                                                                                                \
    "//@ camera eye 0 3 -3 target 0 0 0\n#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"  \
    "uniform float k; //@ slider 0.1 min 0 max 1\nuniform bool grey; //@ checkbox on\n"                      \
    "uniform vec3 tint; //@ color 0 1 0\n"                                                                   \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit); }\n"  \
    "Material scene_material(Hit hit) { return matte(grey ? vec3(k) : 0.5 * tint); }\n"

/* The fourth slider, after the sun's two and the exposure, is the scene's; then its checkbox and its colour,
 * whose picker Escape closes. */
static void test_panel(void **state) {
    (void)state;
    static const int mark[3] = {255, 199, 79}, green[3] = {0, 255, 0};
    int x, y;
    desktop_view(window, "'%s' --size 640x400 --sky uniform --exposure 0",
                 support_write("panel.glsl", PANEL));
    desktop_expect_rest(window, 16);
    double dark = brightness(400, 300, 100, 60);
    desktop_do(window, "key n");
    desktop_expect_number(window, "panel", 1, 1);
    desktop_settle(window);
    find_grab(4, &x, &y);
    press_and_drag(x + 1, y + 4, x + 300, y + 4);
    desktop_expect_rest(window, 16);
    assert_true(brightness(400, 300, 100, 60) > 2 * dark && redness(400, 300, 100, 60) > 0.9);
    assert_true(desktop_find(window, mark, y + 16, &x, &y));
    press_and_drag(x, y, x, y);
    desktop_expect_rest(window, 16);
    double rgb[3];
    desktop_mean(window, 400, 300, 100, 60, rgb);
    assert_true(rgb[1] > 2 * rgb[0] && rgb[1] > 2 * rgb[2]);
    assert_true(desktop_find(window, green, y, &x, &y));
    press_and_drag(x + 2, y + 2, x + 2, y + 2);
    desktop_do(window, "key Escape");
    desktop_settle(window);
    desktop_do(window, "mousemove 500 300");
    desktop_settle(window);
    desktop_quit(window);
}

#define SCENE                                                                                                \
    "//@ title Edited\n//@ camera eye 0 3 -3 target 0 0 0\n#include \"material/matte.glsl\"\n"               \
    "#include \"shape/plane.glsl\"\n#include \"tint.glsl\"\n"                                                \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit); }\n"  \
    "Material scene_material(Hit hit) { return matte(tint()); }\n"

static void test_reload(void **state) {
    (void)state;
    const char *path = support_write("edited.glsl", SCENE);
    support_write("tint.glsl", "vec3 tint() { return vec3(0.8, 0.1, 0.1); }\n");
    desktop_view(window, "'%s' " SMALL " --sky uniform", path);
    desktop_do(window, "key h");
    desktop_expect_samples(window, 16);
    double red = redness(120, 90, 100, 60);
    assert_true(red > 2);
    desktop_do(window, "mousemove 5 5 key equal");
    support_write("tint.glsl", "vec3 tint() { return vec3(0.1, 0.1, 0.8); }\n"); /* which renames */
    desktop_expect(window, "\"event\": \"reload\", ", "\"result\": \"good\"");
    desktop_expect_rest(window, 16);
    assert_true(redness(120, 90, 100, 60) < 0.5);
    desktop_do(window, "mousemove 6 5");
    support_write("tint.glsl", "vec3 tint() {\n    return nonsense;\n}\n");
    desktop_expect(window, "\"result\": \"broken\"", "/tint.glsl:2: ");
    assert_non_null(strstr(desktop_log(window), "\nmagichour: "));
    assert_true(redness(120, 90, 100, 60) < 0.5);
    desktop_do(window, "mousemove 7 5");
    FILE *file = fopen(support_path("tint.glsl"), "w"); /* in place */
    fputs("vec3 tint() { return vec3(0.1, 0.8, 0.1); }\n", file);
    fclose(file);
    desktop_expect(window, "\"result\": \"good\"", "");
    desktop_expect_rest(window, 16);
    double rgb[3];
    desktop_mean(window, 120, 90, 100, 60, rgb);
    assert_true(rgb[1] > 2 * rgb[0] && rgb[1] > 2 * rgb[2]);
    desktop_do(window, "mousemove 8 5");
    support_write("edited.glsl", "#include \"late.glsl\"\n" SCENE);
    desktop_expect(window, "\"result\": \"broken\"", "edited.glsl:1: no file 'late.glsl'");
    desktop_do(window, "mousemove 9 5");
    support_write("late.glsl", "float late() { return 1.0; }\n");
    desktop_expect(window, "\"result\": \"good\"", "");
    desktop_do(window, "mousemove 10 5");
    support_write("balls.csv", "0,0.5,0,0.5\n");
    support_write("edited.glsl", "//@ spheres balls.csv\n#include \"shape/spheres.glsl\"\n" SCENE);
    desktop_expect(window, "\"result\": \"good\"", "");
    desktop_do(window, "mousemove 11 5");
    support_write("balls.csv", "0,1.5,0,0.5\n");
    desktop_expect(window, "\"result\": \"good\"", "");
    desktop_do(window, "mousemove 12 5");
    unlink(path);
    desktop_expect(window, "\"result\": \"broken\"", "edited.glsl: cannot be read");
    assert_true(desktop_number(window, "exposure") == 0.25); /* it was set in the window, and stays */
    desktop_quit(window);
}

static void test_sides(void **state) {
    (void)state;
    desktop_view(window, "\"$here\"/scenes/crater.glsl " SMALL " --sky uniform");
    desktop_do(window, "key h key v");
    desktop_expect_number(window, "sides", 2, 2);
    desktop_expect_samples(window, 32);
    double left = brightness(20, 4, 100, 30), right = brightness(200, 4, 100, 30);
    assert_true(left > 100 && fabs(left / right - 1) < 0.01);
    desktop_do(window, "key f");
    desktop_expect_samples(window, 64);
    double rgb[3];
    desktop_mean(window, 20, 4, 280, 30, rgb); /* the sky is the same: Moreland's grey */
    for (int c = 0; c < 3; c++) assert_true(fabs(rgb[c] - 221) < 2);
    /* The right side's sun sets; with a sky that has one, it darkens. */
    desktop_do(window, "key f");
    desktop_quit(window);
    desktop_view(window, "\"$here\"/scenes/crater.glsl " SMALL);
    desktop_do(window, "key h key v key b mousemove 240 60 mousedown 3 mousemove 240 150 mouseup 3");
    desktop_expect_samples(window, 32);
    assert_true(desktop_number(window, "elevation") == 30);
    assert_true(brightness(20, 4, 100, 60) > 3 * brightness(200, 4, 100, 60));
    desktop_do(window, "key Return key minus key 4 key Return"); /* where the pointer is: the right one's */
    desktop_expect_number(window, "right_elevation", -4, -4);
    assert_true(desktop_number(window, "elevation") == 30);
    /* The divider is dragged to the left: so is the dark. */
    desktop_do(window, "mousemove 160 90 mousedown 1 mousemove 100 90 mousemove 15 90 mouseup 1");
    desktop_expect_samples(window, 48);
    assert_true(darkens(30, 4, 100, 60, 100));
    assert_true(desktop_number(window, "eye_x") == 0);
    desktop_quit(window);
}

static void test_window(void **state) {
    (void)state;
    desktop_view(window, "crater " SMALL);
    desktop_do(window, "search --name Crater windowsize 401 203");
    desktop_expect_number(window, "width", 401, 401);
    desktop_expect_number(window, "height", 203, 203);
    desktop_expect_rest(window, 16);
    assert_true(brightness(340, 100, 50, 90) > 20);
    desktop_do(window, "search --name Crater windowsize 1 1");
    desktop_expect_number(window, "width", 1, 1);
    desktop_do(window, "search --name Crater windowsize 320 180");
    desktop_expect_number(window, "width", 320, 320);
    desktop_do(window, "search --name Crater windowunmap");
    desktop_also(window, "search --name Crater windowmap");
    desktop_do(window, "mousemove 200 100 key i");
    desktop_expect_samples(window, 16);
    desktop_signal(window, SIGINT);
    assert_int_equal(desktop_end(window), 130);
    support_expect(2, "usage: magichour view", "view");
    support_expect(3, "no-such.glsl: cannot be read", "view no-such.glsl");
    support_expect(5, "no folder can be made there: No such file or directory",
                   "view scenes/crater.glsl --record '%s/x/y'", support_path("none"));
    support_expect(3, "has no scene of this name: did you mean crater?", "view cratr");
    assert_int_equal(
        support_run("env -u DISPLAY -u WAYLAND_DISPLAY -u XDG_RUNTIME_DIR", "view scenes/crater.glsl"), 4);
    assert_non_null(strstr(support_err, "`magichour render scenes/crater.glsl -o FILE.png`"));
    assert_true(strchr(support_err, '\n') == support_err + strlen(support_err) - 1);
}

/* A library of one's own is watched too, whole. */
static void test_reload_library(void **state) {
    (void)state;
    char command[1024];
    Text matte = {0};
    Error error;
    const char *path = support_path("library/material/matte.glsl");
    snprintf(command, sizeof command, "rm -rf '%s' && cp -r glsl '%s'", support_path("library"),
             support_path("library"));
    assert_int_equal(system(command), 0);
    desktop_view(window, "\"$here\"/scenes/crater.glsl " SMALL " --sky uniform --glsl-dir library");
    desktop_do(window, "mousemove 5 5 key h");
    assert_true(file_read(path, STATUS_FAILURE, &matte, &error));
    text_print(&matte, "broken\n");
    support_write("library/material/matte.glsl", text_string(&matte));
    desktop_expect(window, "\"result\": \"broken\"", "library/material/matte.glsl:");
    desktop_do(window, "mousemove 6 5");
    matte.data[matte.size - strlen("broken\n")] = 0;
    support_write("library/material/matte.glsl", text_string(&matte));
    desktop_expect(window, "\"result\": \"good\"", "");
    text_free(&matte);
    desktop_quit(window);
    snprintf(command, sizeof command, "rm -rf '%s'", support_path("library"));
    assert_int_equal(system(command), 0);
}

/* A side that was opened later catches up, while the other one waits, and then both go on together. The other
 * one has the frame to itself in which the key is heard. The numbers of one frame belong together. */
static void test_equal_time(void **state) {
    (void)state;
    double before, left, right;
    desktop_view(window, "\"$here\"/scenes/crater.glsl " SMALL);
    desktop_expect_number(window, "seconds", 1.5, 1e9);
    desktop_do(window, "key v");
    desktop_expect_pair(window, "sides", 2, "seconds", &before);
    right = desktop_expect_pair(window, "right_seconds", 0.9 * before, "seconds", &left);
    assert_true(left - before < 0.5 * right);
    right = desktop_expect_pair(window, "right_seconds", before + 1.5, "seconds", &left);
    assert_true(left > before + 0.5 && fabs(left - right) < 0.2 * right);
    desktop_quit(window);
}

/* A day's first frames. */
static void test_record(void **state) {
    (void)state;
    desktop_view(window, "\"$here\"/scenes/crater.glsl --size 64x36 --spp 4 --sun 20,0 --record .");
    desktop_expect(window, "\"event\": \"recorded\"", "frame-00003");
    desktop_do(window, "key t");
    desktop_quit(window);
    assert_int_equal(access(support_path("frame-00002.png"), F_OK), 0);
    support_expect(5, "--record scenes/crater.glsl/x: no folder",
                   "view scenes/crater.glsl --record scenes/crater.glsl/x");
}

#define TOY                                                                                                  \
    "void mainImage(out vec4 fragColor, in vec2 fragCoord) {\n"                                              \
    "    vec2 uv = fragCoord / iResolution.xy;\n"                                                            \
    "    vec4 before = texture(iChannel0, uv);\n"                                                            \
    "    fragColor = vec4(uv.y, min(before.g + 0.01, 0.5), iTime > 0.0 ? 0.8 : 0.0, 1.0);\n}\n"

static void test_shadertoy(void **state) {
    (void)state;
    const char *path = support_write("toy.glsl", TOY);
    int rgb[3];
    desktop_view(window, "'%s' " SMALL, path);
    desktop_do(window, "key h");
    desktop_expect_samples(window, 80);
    desktop_pixel(window, 160, 20, rgb); /* y is up */
    assert_true(abs(rgb[0] - 227) < 4 && abs(rgb[1] - 128) < 3 && abs(rgb[2] - 204) < 3);
    /* A scene that names iTime is given it, and stands still until it is let run. */
    support_write("toy.glsl",
                  "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"
                  "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                  "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n}\n"
                  "Material scene_material(Hit hit) { return matte(vec3(iTime < 1.0 ? 0.8 : 0.1)); }\n");
    desktop_expect(window, "\"result\": \"good\"", "");
    desktop_do(window, "key space key z");
    desktop_expect_rest(window, 32);
    double bright = brightness(20, 150, 280, 20);
    desktop_do(window, "key space");
    assert_true(darkens(20, 150, 280, 20, 0.7 * bright));
    desktop_quit(window);
}

#define ORDERS                                                                                               \
    "//@ preset sunset sun.elevation 5 atmosphere.mie 0.5\n"                                                 \
    "//@ camera eye 0 3 -3 target 0 3 0\n#include \"material/matte.glsl\"\n"                                 \
    "#include \"shape/plane.glsl\"\n"                                                                        \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit); }\n"  \
    "Material scene_material(Hit hit) { return matte(vec3(0.5)); }\n"

/* The frames from this place of the log on that were shown before the sky was ready. */
static int frames_before_ready(const char *log) {
    int count = 0;
    for (const char *at = log; (at = strstr(at, "\"prepared\": ")); at++)
        count += strtod(at + strlen("\"prepared\": "), NULL) < 1;
    return count;
}

/* All orders of scattering are computed in steps, between which frames are shown and events are heard. How
 * many steps they are depends on the machine: a GPU may need one. */
static void test_long_sky(void **state) {
    (void)state;
    desktop_view(window, "'%s' " SMALL " --set atmosphere.orders=all", support_write("orders.glsl", ORDERS));
    desktop_expect_rest(window, 16);
    bool slow = strstr(desktop_log(window), "llvmpipe") != NULL;
    assert_true(!slow || frames_before_ready(desktop_log(window)) > 1);
    assert_true(desktop_number(window, "prepared") == 1);
    desktop_do(window, "key h");
    desktop_settle(window);
    double noon = brightness(20, 4, 280, 60);
    assert_true(noon > 40);
    size_t before = strlen(desktop_log(window));
    desktop_do(window, "key 3 key Up key Up");
    /* The last picture stays until the next one has begun. */
    if (slow) desktop_expect_number(window, "prepared", 0, 0.999);
    assert_true(brightness(20, 4, 280, 60) > 40);
    desktop_expect_number(window, "elevation", 7, 7);
    desktop_expect_rest(window, 16);
    assert_true(!slow || frames_before_ready(desktop_log(window) + before) > 1);
    assert_true(desktop_number(window, "prepared") == 1);
    assert_true(brightness(20, 4, 280, 60) < 0.95 * noon);
    desktop_quit(window);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_sun, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_day, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_wrong_values, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_camera, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_panel, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_reload, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_reload_library, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_sides, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_window, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_equal_time, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_record, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_shadertoy, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_long_sky, desktop_setup, desktop_teardown),
    };
    return cmocka_run_group_tests_name("window", tests, support_folder, support_clean);
}
