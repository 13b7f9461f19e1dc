/* The window under a storm of events and edits; and, run as `test_window_load measure SCENE SIZE`, its speed.
 */
#include "desktop.h"

#include "base/clock.h"
#include "base/text.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define SCENE                                                                                                \
    "//@ title Edited\n//@ camera eye 0 3 -3 target 0 0 0\n#include \"material/matte.glsl\"\n"               \
    "#include \"shape/plane.glsl\"\n#include \"tint.glsl\"\n"                                                \
    "void scene_intersect(Ray ray, INOUT(Hit) hit) { hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit); }\n"  \
    "Material scene_material(Hit hit) { return matte(tint()); }\n"

/* Events at random, and edits between: MAGICHOUR_EVENTS and MAGICHOUR_RELOADS say how many. */
static unsigned dice(unsigned *seed, unsigned sides) {
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 16) % sides;
}

static void random_event(unsigned *seed, Text *script) {
    static const char keys[][13] = {
        "h",     "v",      "f",     "b",     "x",     "i",      "r",    "c",           "t",
        "p",     "1",      "2",     "3",     "4",     "5",      "z",    "w",           "a",
        "s",     "d",      "e",     "q",     "Up",    "Down",   "Left", "Right",       "shift+Up",
        "comma", "period", "minus", "equal", "space", "Return", "Tab",  "bracketleft", "bracketright",
        "ctrl+c"};
    enum { KEYS = sizeof keys / sizeof *keys };
    unsigned kind = dice(seed, 10);
    if (kind < 5)
        text_print(script, " key %s", keys[dice(seed, KEYS)]);
    else if (kind < 8)
        text_print(script, " mousemove %u %u mousedown %u mousemove %u %u mouseup %u", dice(seed, 490),
                   dice(seed, 280), 1 + kind - 5, dice(seed, 490), dice(seed, 280), 1 + kind - 5);
    else if (kind < 9)
        text_print(script, " click %u", 4 + dice(seed, 2));
    else
        text_print(script, " search --name Edited windowsize %u %u", 1 + dice(seed, 600),
                   1 + dice(seed, 400));
}

static int wished(const char *variable, int otherwise) {
    const char *text = getenv(variable);
    return text ? atoi(text) : otherwise;
}

static void test_storm(void **state) {
    (void)state;
    int events = wished("MAGICHOUR_EVENTS", 60), reloads = wished("MAGICHOUR_RELOADS", 6);
    unsigned seed = 1;
    const char *path = support_write("edited.glsl", SCENE);
    support_write("tint.glsl", "vec3 tint() { return vec3(0.5); }\n");
    desktop_view(window, "'%s' --size 480x270 --sun-disk", path);
    for (int done = 0; done < events;) {
        Text script = {0};
        for (int i = 0; i < 10 && done < events; i++, done++) random_event(&seed, &script);
        desktop_do(window, "%s", text_string(&script));
        text_free(&script);
        desktop_expect(window, "\"event\": \"frame\"", "");
    }
    for (int i = 0; i < reloads; i++) {
        char text[128];
        bool broken = i % 5 == 4;
        snprintf(text, sizeof text, "vec3 tint() { return vec3(%g%s); }\n", 0.1 + 0.004 * (i % 200),
                 broken ? ", " : "");
        desktop_do(window, "mousemove %d 20", i % 100);
        support_write("tint.glsl", text);
        desktop_expect(window, "\"event\": \"reload\"", broken ? "broken" : "good");
    }
    desktop_signal(window, SIGTERM);
    assert_int_equal(desktop_end(window), 130);
    assert_null(strstr(desktop_log(window), "OpenGL error"));
}

enum { MOST_TIMES = 4096 };

static int by_size(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void print_times(const char *what, double *times, int count) {
    qsort(times, (size_t)count, sizeof *times, by_size);
    if (count) printf("%s: %.0f ms (median), %.0f ms (worst)\n", what, times[count / 2], times[count - 1]);
}

/* From an event's arrival, at the earliest, to its picture, by the log from byte `from` on. */
static void measure_answers(size_t from) {
    double times[MOST_TIMES];
    int count = 0;
    for (const char *at = desktop_log(window) + from;
         (at = strstr(at, "\"latency_ms\": ")) && count < MOST_TIMES; at++) {
        sscanf(at, "\"latency_ms\": %lf", &times[count]);
        count += times[count] > 0;
    }
    print_times("from an event to its picture", times, count);
}

/* The times of the frames that the log has from byte `from` on, in order. */
static int frame_times(size_t from, double times[MOST_TIMES]) {
    int count = 0;
    for (const char *at = desktop_log(window) + from;
         (at = strstr(at, "\"frame_ms\": ")) && count < MOST_TIMES; at++)
        count += sscanf(at, "\"frame_ms\": %lf", &times[count]) == 1;
    qsort(times, (size_t)count, sizeof *times, by_size);
    return count;
}

/* A hand that moves the sun and halts now and then. */
static void move_sun(int moves) {
    Text script = {0};
    text_print(&script, "mousemove 200 100 mousedown 3");
    for (int i = 0; i < moves; i++)
        text_print(&script, " mousemove %d %d sleep %s", 200 + i % 40, 100 + i % 50,
                   i % 15 ? "0.015" : "0.3");
    text_print(&script, " mouseup 3");
    desktop_do(window, "%s", text_string(&script));
    text_free(&script);
}

/* In the heaviest scene, whose sky has all orders of scattering and whose sun comes into view, each halt of
 * the hand is answered by a picture, and pictures are shown in between. Their times are figures and not
 * asserted, since a machine may be busy with other work: `measure` prints them. */
static void test_motion(void **state) {
    (void)state;
    double times[MOST_TIMES];
    desktop_view(window, "\"$here\"/scenes/spheres.glsl --size 480x300");
    desktop_expect_number(window, "samples", 1, 1e9);
    desktop_expect_number(window, "prepared", 1, 1);
    desktop_do(window, "key h");
    desktop_expect_number(window, "seconds", 0.5, 1e9);
    size_t from = strlen(desktop_log(window));
    move_sun(90);
    int count = frame_times(from, times);
    print_message("%d frames: %.0f ms (median), %.0f ms (worst)\n", count, times[count / 2],
                  times[count - 1]);
    assert_true(count > 2 * (90 / 15));
    desktop_quit(window);
}

/* From a key to another pixel on the screen, with the time that xdotool takes to start. */
static void measure_latency(void) {
    enum { TIMES = 15 };
    double times[TIMES];
    for (int i = 0; i < TIMES; i++) {
        double before[3], now[3];
        usleep(1200000);
        desktop_mean(window, 300, 20, 4, 4, before);
        double start_s = clock_seconds();
        desktop_do(window, "key --delay 0 %d", i % 2 ? 3 : 1);
        do desktop_mean(window, 300, 20, 4, 4, now);
        while (fabs(now[0] - before[0]) < 3 && clock_seconds() < start_s + 2);
        times[i] = 1e3 * (clock_seconds() - start_s);
    }
    print_times("from xdotool's start to another pixel on the screen", times, TIMES);
}

/* What a picture's error truly is: against one of many samples and another seed. */
static void measure_error(const char *scene, const char *size, const char *picture) {
    const char *reference = support_path("reference.exr");
    double elevation = desktop_number(window, "elevation"), azimuth = desktop_number(window, "azimuth");
    assert_int_equal(support_run("",
                                 "render '%s' -o '%s' --quiet --size %s --spp 512 --seed 9 --sun %.9g,%.9g",
                                 scene, reference, size, elevation, azimuth),
                     0);
    assert_int_equal(support_run("", "compare '%s' '%s'", picture, reference), 0);
    printf("its error against 512 samples:\n%s", support_out);
}

/* Not a test: figures of this machine, for the scene and the size that are given. */
static int measure(const char *scene, const char *size) {
    double seconds = 3;
    char picture[512];
    void *state = NULL;
    if (support_folder(&state) != 0) return 1;
    desktop_setup(&state);
    desktop_view(window, "\"$here\"/%s --size %s", scene, size);
    usleep(2000000);
    Text script = {0};
    text_print(&script, "mousemove 500 100 mousedown 3");
    for (int i = 0; i < seconds / 0.015; i++)
        text_print(&script, " mousemove 500 %d sleep 0.015", 100 + i % 100);
    size_t log = strlen(desktop_log(window));
    double frames = desktop_number(window, "frame"), from = clock_seconds();
    desktop_do(window, "%s", text_string(&script));
    frames = desktop_number(window, "frame") - frames;
    printf("%s %s: %.1f updates a second while the sun is dragged, 1 / %.0f of the size\n", scene, size,
           frames / (clock_seconds() - from), desktop_number(window, "coarseness"));
    measure_answers(log);
    double times[MOST_TIMES];
    print_times("a frame", times, frame_times(log, times));
    desktop_do(window, "mouseup 3");
    usleep(2000000);
    snprintf(picture, sizeof picture, "%s", desktop_save(window, "exr"));
    printf("after 2 s of rest: %.0f samples, error about %.2f %%\n", desktop_number(window, "samples"),
           desktop_number(window, "error_percent"));
    measure_error(scene, size, picture);
    measure_latency();
    text_free(&script);
    desktop_quit(window);
    desktop_teardown(&state);
    return support_clean(&state);
}

int main(int argc, char **argv) {
    if (argc > 3 && strcmp(argv[1], "measure") == 0) return measure(argv[2], argv[3]);
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_storm, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_motion, desktop_setup, desktop_teardown),
    };
    return cmocka_run_group_tests_name("window_load", tests, support_folder, support_clean);
}
