/* Files that paint their pictures by themselves, in the window: frames that are recorded, each file of
 * tests/data/toys among them (tests/test_toy.c says what they expect). */
#include "base/clock.h"
#include "desktop.h"
#include "image/tone.h"
#include "toys.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static Image read_frame(const char *name) {
    Image image;
    Error error;
    if (!image_read(&image, support_path(name), &error)) fail_msg("%s", error.text);
    return image;
}

/* The third frame of a record at a frame a second is that of iTime 2. */
static void test_toys(void **state) {
    (void)state;
    char words[300];
    int count = 0;
    for (const char *toy; (toy = toys_next()); count++) {
        bool refused = toys_line(toy, "refused", 0, words, sizeof words);
        desktop_start(window, "\"$here\"/%s --size 40x30 --record . --frames 3 --fps 1", toy);
        int status = desktop_end(window);
        if (status != (refused ? 3 : 0)) {
            desktop_print_last(window);
            fail_msg("%s: status %d", toy, status);
        }
        for (int i = 0; toys_line(toy, refused ? "refused" : "warns", i, words, sizeof words); i++) {
            if (!strstr(desktop_log(window), words))
                fail_msg("%s: no '%s' in: %s", toy, words, desktop_log(window));
        }
        if (refused) continue;
        Image image = read_frame("frame-00003.png");
        toys_check(toy, &image);
        image_free(&image);
        assert_int_not_equal(access(support_path("frame-00004.png"), F_OK), 0);
        assert_int_equal(unlink(support_path("frame-00003.png")), 0);
    }
    assert_true(count >= 30);
}

/* A folder is a program of several tabs: Image shows what Buffer A has drawn for the same frame. */
static void test_tabs(void **state) {
    (void)state;
    support_write("common.glsl", "const float STEP = 0.125;\n");
    support_write("buffer-a.glsl", "void mainImage(out vec4 c, in vec2 p) {\n"
                                   "    c = texelFetch(iChannel0, ivec2(p), 0) + STEP;\n}\n");
    support_write("image.glsl", "void mainImage(out vec4 c, in vec2 p) {\n"
                                "    c = vec4(texelFetch(iChannel0, ivec2(p), 0).r, STEP, iTime, 1.0);\n}\n");
    desktop_start(window, "'%s' --size 8x8 --record tabs --frames 4 --fps 4", support_path(""));
    assert_int_equal(desktop_end(window), 0);
    Image image = read_frame("tabs/frame-00003.png");
    for (int c = 0; c < 3; c++) {
        static const double wanted[] = {3 * 0.125, 0.125, 0.5};
        double level = tone_level(TONE_NONE, 1, (double)image.rgba[c]);
        if (fabs(level - 255 * wanted[c]) > 1.01) fail_msg("channel %d: level %g", c, level);
    }
    image_free(&image);
}

#define CLOCK                                                                                                \
    "void mainImage(out vec4 c, in vec2 p) {\n"                                                              \
    "    c = vec4(iTime, iTimeDelta, float(iFrame), 1.0) / vec4(1.0, 1.0, 255.0, 1.0);\n"                    \
    "    c.b += texture(iChannel0, p / iResolution.xy).b;\n}\n"

static void expect_level(const Image *image, int channel, double wanted) {
    double level = tone_level(TONE_NONE, 1, (double)image->rgba[channel]);
    if (fabs(level - wanted) > 1.01) fail_msg("channel %d: %g, not %g", channel, level, wanted);
}

/* Frames follow the number of the frame, and not the clock; each sees the one before. */
static void test_clock(void **state) {
    (void)state;
    const char *toy = support_write("clock.glsl", CLOCK);
    desktop_start(window, "'%s' --size 8x8 --set time=0.25 --record clock --frames 12 --fps 20", toy);
    assert_int_equal(desktop_end(window), 0);
    Image frame = read_frame("clock/frame-00011.png");
    expect_level(&frame, 0, 255 * 0.75);
    expect_level(&frame, 1, 255 * 0.05);
    /* 0 + 1 + ... + 10 */
    expect_level(&frame, 2, 55);
    image_free(&frame);
}

/* A day of a scene is cut to so many frames, which are so far apart. */
static void test_scene(void **state) {
    (void)state;
    desktop_start(
        window,
        "\"$here\"/scenes/crater.glsl --size 32x18 --spp 4 --sun 20,0 --record day --frames 2 --fps 50");
    assert_int_equal(desktop_end(window), 0);
    assert_int_equal(access(support_path("day/frame-00002.png"), F_OK), 0);
    assert_int_not_equal(access(support_path("day/frame-00003.png"), F_OK), 0);
    support_expect(2, "--sky: tests/data/toys/plain.glsl paints",
                   "view tests/data/toys/plain.glsl --sky table");
    support_expect(2, "--frames: 0 is outside the range from 1", "view scenes/crater.glsl --frames 0");
    support_expect(2, "--fps: ", "view scenes/crater.glsl --fps 0");
}

/* Less than the rest of a compilation of more than four seconds. */
static const double soon = 3;

/* Asks the window to end while it compiles, and gives the seconds that it took. */
static double seconds_to_end(int signal, int wanted) {
    desktop_expect(window, "\"event\": \"compiling\"", "");
    double start = clock_seconds();
    if (signal)
        desktop_signal(window, signal);
    else
        desktop_do(window, "key Escape");
    int status = desktop_end(window);
    if (status != wanted) fail_msg("status %d", status);
    return clock_seconds() - start;
}

/* A compilation of seconds is shown as such. The picture before stays, the window can be closed, and the new
 * picture follows. */
static void test_compiling(void **state) {
    (void)state;
    int rgb[3];
    desktop_view(window, "\"$here\"/tests/data/toys/plain.glsl --size 320x180");
    bool slow = strstr(desktop_log(window), "llvmpipe") != NULL;
    desktop_do(window, "key h");
    desktop_quit(window);
    if (!slow) {
        print_message("this OpenGL compiles quickly\n");
        return;
    }
    desktop_start(window, "'%s' --size 320x180", toys_write_slow("slow.glsl"));
    assert_true(seconds_to_end(0, 0) < soon);
    desktop_start(window, "'%s' --size 320x180", toys_write_slow("slow.glsl"));
    assert_true(seconds_to_end(SIGTERM, 130) < soon);
    desktop_start(window, "'%s' --size 320x180", toys_write_slow_scene("slow.glsl"));
    assert_true(seconds_to_end(SIGINT, 130) < soon);

    support_write("slow.glsl", "void mainImage(out vec4 c, in vec2 p) { c = vec4(0.0, 0.2, 1.0, 1.0); }\n");
    desktop_view(window, "'%s' --size 320x180", support_path("slow.glsl"));
    desktop_do(window, "key h mousemove 10 10");
    desktop_settle(window);
    toys_write_slow("slow.glsl");
    desktop_expect(window, "\"event\": \"compiling\"", "");
    desktop_pixel(window, 300, 20, rgb);
    assert_true(rgb[0] < 4 && abs(rgb[1] - 51) < 4 && rgb[2] > 250);
    /* The line's amber stands below. */
    static const int amber[3] = {255, 199, 79};
    int x, y;
    bool found = desktop_find(window, amber, 150, &x, &y);
    desktop_expect(window, "\"result\": \"good\"", "");
    desktop_pixel(window, 300, 20, rgb);
    for (double end = clock_seconds() + 60; clock_seconds() < end && rgb[2] > 4;)
        desktop_pixel(window, 300, 20, rgb);
    assert_true(abs(rgb[1] - 153) < 4 && rgb[2] < 4);
    assert_true(found);
    desktop_quit(window);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_toys, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_tabs, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_clock, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_scene, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_compiling, desktop_setup, desktop_teardown),
    };
    return cmocka_run_group_tests_name("window_toy", tests, support_folder, support_clean);
}
