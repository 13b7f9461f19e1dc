/* The window, by real events on a display of its own: each step is checked on the log or on the screen's
 * pixels. */
#include "desktop.h"

#include "base/clock.h"
#include "base/file.h"
#include "view/carry.h"
#include "view/day.h"
#include "view/orbit.h"

#include <math.h>
#include <png.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define SMALL "--size 320x180"

static Desktop *desktop;

static int start(void **state) {
    (void)state;
    desktop = desktop_start();
    return 0;
}

static int stop(void **state) {
    (void)state;
    desktop_stop(desktop);
    desktop = NULL;
    return 0;
}

static void quit(void) {
    desktop_do(desktop, "key Escape");
    assert_int_equal(desktop_end(desktop), 0);
    assert_non_null(strstr(desktop_log(desktop), "\"event\": \"end\""));
    assert_null(strstr(desktop_log(desktop), "OpenGL error"));
}

static double redness(int x, int y, int width, int height) {
    double rgb[3];
    desktop_mean(desktop, x, y, width, height, rgb);
    return rgb[0] / (rgb[2] + 1);
}

static double brightness(int x, int y, int width, int height) {
    double rgb[3];
    desktop_mean(desktop, x, y, width, height, rgb);
    return (rgb[0] + rgb[1] + rgb[2]) / 3;
}

/* 56 pixels of half a degree: 30 to 2 degrees. */
static void test_sun(void **state) {
    (void)state;
    desktop_view(desktop, "\"$here\"/scenes/crater.glsl " SMALL);
    desktop_expect_rest(desktop, 16);
    desktop_do(desktop, "key h");
    usleep(300000);
    double noon = redness(100, 30, 120, 12);
    desktop_do(
        desktop,
        "mousemove 160 90 mousedown 3 mousemove 160 110 mousemove 160 130 mousemove 160 146 mouseup 3");
    desktop_expect_number(desktop, "elevation", 1.999, 2.001);
    desktop_expect_rest(desktop, 16);
    assert_true(redness(100, 30, 120, 12) > 1.5 * noon);
    desktop_do(desktop, "keydown s mousemove 160 100 mousedown 1 mousemove 180 90 mouseup 1 keyup s");
    desktop_expect_number(desktop, "elevation", 6.999, 7.001);
    desktop_expect_number(desktop, "azimuth", 349.99, 350.01);
    assert_true(desktop_number(desktop, "eye_z") == -4);
    desktop_do(desktop, "key Return key minus key 4 key Return");
    desktop_expect_number(desktop, "elevation", -4, -4);
    desktop_do(desktop, "key Return type --delay 12 '12.5, 90'");
    desktop_also(desktop, "key Return");
    desktop_expect_number(desktop, "elevation", 12.5, 12.5);
    desktop_expect_number(desktop, "azimuth", 90, 90);
    static const double elevations[] = {60, 30, 5, -2}, exposures[] = {0, 0, 0.5, 4};
    for (int i = 3; i >= 0; i--) {
        desktop_do(desktop, "key %d", i + 1);
        desktop_expect_number(desktop, "elevation", elevations[i], elevations[i]);
        assert_true(desktop_number(desktop, "exposure") == exposures[i]);
    }
    desktop_do(desktop, "key Up key Left key shift+Down");
    desktop_expect_number(desktop, "elevation", 60.8999, 60.9001);
    desktop_expect_number(desktop, "azimuth", 91, 91);
    quit();
}

static void test_day(void **state) {
    (void)state;
    desktop_view(desktop, "\"$here\"/scenes/crater.glsl " SMALL " --sun 10,0");
    desktop_do(desktop, "key period key period key t");
    desktop_expect_number(desktop, "elevation", 30, 59);
    desktop_expect_number(desktop, "elevation", 59, 60.0001);
    desktop_expect_number(desktop, "elevation", -18, 0);
    desktop_do(desktop, "key t");
    desktop_expect_rest(desktop, 16);
    quit();
}

static void test_camera(void **state) {
    (void)state;
    desktop_view(desktop, "\"$here\"/scenes/crater.glsl " SMALL " --progress none --set ball=0");
    desktop_do(desktop, "key h");
    desktop_do(desktop, "mousemove 160 90 mousedown 1 mousemove 200 90 mousemove 205 80 mouseup 1");
    desktop_expect_number(desktop, "eye_x", 2, 4.4);
    assert_true(fabs(hypot(hypot(desktop_number(desktop, "eye_x"), desktop_number(desktop, "eye_y")),
                           desktop_number(desktop, "eye_z")) -
                     sqrt(20)) < 1e-6);
    desktop_do(desktop, "click 4 click 4");
    desktop_expect_number(desktop, "samples", 16, 1e9);
    assert_true(fabs(hypot(hypot(desktop_number(desktop, "eye_x"), desktop_number(desktop, "eye_y")),
                           desktop_number(desktop, "eye_z")) -
                     0.81 * sqrt(20)) < 1e-6);
    double before = desktop_number(desktop, "eye_y");
    desktop_do(desktop, "keydown e");
    desktop_expect_number(desktop, "eye_y", before + 0.05, 100);
    desktop_do(desktop, "keyup e key r");
    desktop_expect_number(desktop, "eye_x", 0, 0);
    assert_true(desktop_number(desktop, "eye_y") == 2 && desktop_number(desktop, "eye_z") == -4);
    desktop_do(desktop, "key c");
    desktop_expect(desktop,
                   "//@ camera  eye 0 2 -4  target 0 0 0  fov 90\\u000a//@ sun     elevation 30  azimuth 0",
                   "");
    quit();
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
    desktop_view(desktop, "'%s' " SMALL " --sky uniform", path);
    desktop_do(desktop, "key h");
    desktop_expect_number(desktop, "samples", 16, 1e9);
    double red = redness(120, 90, 100, 60);
    assert_true(red > 2);
    desktop_do(desktop, "mousemove 5 5 key equal");
    support_write("tint.glsl", "vec3 tint() { return vec3(0.1, 0.1, 0.8); }\n"); /* which renames */
    desktop_expect(desktop, "\"event\": \"reload\", ", "\"result\": \"good\"");
    desktop_expect_rest(desktop, 16);
    assert_true(redness(120, 90, 100, 60) < 0.5);
    desktop_do(desktop, "mousemove 6 5");
    support_write("tint.glsl", "vec3 tint() {\n    return nonsense;\n}\n");
    desktop_expect(desktop, "\"result\": \"broken\"", "/tint.glsl:2: ");
    assert_non_null(strstr(desktop_log(desktop), "\nmagichour: "));
    assert_true(redness(120, 90, 100, 60) < 0.5);
    desktop_do(desktop, "mousemove 7 5");
    FILE *file = fopen(support_path("tint.glsl"), "w"); /* in place */
    fputs("vec3 tint() { return vec3(0.1, 0.8, 0.1); }\n", file);
    fclose(file);
    desktop_expect(desktop, "\"result\": \"good\"", "");
    desktop_expect_rest(desktop, 16);
    double rgb[3];
    desktop_mean(desktop, 120, 90, 100, 60, rgb);
    assert_true(rgb[1] > 2 * rgb[0] && rgb[1] > 2 * rgb[2]);
    desktop_do(desktop, "mousemove 8 5");
    support_write("edited.glsl", "#include \"late.glsl\"\n" SCENE);
    desktop_expect(desktop, "\"result\": \"broken\"", "edited.glsl:1: no file 'late.glsl'");
    desktop_do(desktop, "mousemove 9 5");
    support_write("late.glsl", "float late() { return 1.0; }\n");
    desktop_expect(desktop, "\"result\": \"good\"", "");
    desktop_do(desktop, "mousemove 10 5");
    support_write("balls.csv", "0,0.5,0,0.5\n");
    support_write("edited.glsl", "//@ spheres balls.csv\n#include \"shape/spheres.glsl\"\n" SCENE);
    desktop_expect(desktop, "\"result\": \"good\"", "");
    desktop_do(desktop, "mousemove 11 5");
    support_write("balls.csv", "0,1.5,0,0.5\n");
    desktop_expect(desktop, "\"result\": \"good\"", "");
    desktop_do(desktop, "mousemove 12 5");
    unlink(path);
    desktop_expect(desktop, "\"result\": \"broken\"", "edited.glsl: cannot be read");
    assert_true(desktop_number(desktop, "exposure") == 0.25); /* it was set in the window, and stays */
    quit();
}

/* The `render` command that a PNG was saved with, in the text of its metadata. */
static void saved_command(const char *png, char *command, size_t size) {
    Text file = {0};
    Error error;
    if (!file_read(png, STATUS_FAILURE, &file, &error)) fail_msg("%s", error.text);
    const char *start = NULL;
    for (size_t i = 0; i + 17 < file.size && !start; i++) {
        if (memcmp(file.data + i, "magichour render ", 17) == 0) start = file.data + i + strlen("magichour ");
    }
    assert_non_null(start);
    size_t length = 0;
    while (start[length] >= ' ' && start[length] < 127 && length + 1 < size) length++;
    /* What follows the text is four bytes of checksum, which may be printable, so that the end is looked for.
     */
    snprintf(command, size, "%.*s", (int)length, start);
    text_free(&file);
}

static void compare_with_screen(const char *png) {
    png_image image = {.version = PNG_IMAGE_VERSION};
    assert_true(png_image_begin_read_from_file(&image, png));
    image.format = PNG_FORMAT_RGB;
    unsigned char *bytes = memory_get(PNG_IMAGE_SIZE(image), 1);
    assert_true(png_image_finish_read(&image, NULL, bytes, 0, NULL));
    int different = 0, far = 0;
    for (unsigned y = 10; y < image.height; y += 9) {
        for (unsigned x = 0; x < image.width; x += 7) {
            int rgb[3];
            desktop_pixel(desktop, (int)x, (int)y, rgb);
            for (int c = 0; c < 3; c++) {
                int apart = abs(rgb[c] - bytes[3 * (y * image.width + x) + (unsigned)c]);
                different += apart > 0;
                far += apart > 1;
            }
        }
    }
    free(bytes);
    assert_int_equal(far, 0);
    assert_true(different < 10);
}

static void test_save(void **state) {
    (void)state;
    char command[4096];
    desktop_view(desktop, "\"$here\"/scenes/crater.glsl " SMALL " --spp 48 --seed 7 --set hover=0.75");
    desktop_do(desktop, "key h mousemove 100 90 mousedown 1 mousemove 110 93 mouseup 1 key 3");
    desktop_expect_rest(desktop, 48);
    desktop_do(desktop, "mousemove 700 500 key p"); /* the pointer out of the picture */
    const char *line = desktop_expect(desktop, "\"event\": \"save\"", "\"message\": \"\"");
    assert_non_null(strstr(line, "crater-001"));
    compare_with_screen(support_path("crater-001.png"));
    quit();
    saved_command(support_path("crater-001.png"), command, sizeof command);
    char *end = strstr(command, " --set hover=0.75");
    assert_non_null(end);
    end[strlen(" --set hover=0.75")] = 0;
    char *output = strstr(command, "-o picture.exr ");
    assert_non_null(output);
    memset(output, ' ', strlen("-o picture.exr "));
    const char *again = support_path("again.exr"), *saved = support_path("crater-001.exr");
    assert_int_equal(support_run("", "%s --quiet -o '%s'", command, again), 0);
    assert_int_equal(support_run("", "compare '%s' '%s' --max-relrmse 0", saved, again), 0);
}

static void test_sides(void **state) {
    (void)state;
    desktop_view(desktop, "\"$here\"/scenes/crater.glsl " SMALL " --sky uniform");
    desktop_do(desktop, "key h key v");
    desktop_expect_number(desktop, "sides", 2, 2);
    desktop_expect_number(desktop, "samples", 32, 1e9);
    double left = brightness(20, 4, 100, 30), right = brightness(200, 4, 100, 30);
    assert_true(left > 100 && fabs(left / right - 1) < 0.01);
    desktop_do(desktop, "key f");
    desktop_expect_number(desktop, "samples", 64, 1e9);
    double rgb[3];
    desktop_mean(desktop, 20, 4, 280, 30, rgb); /* the sky is the same: Moreland's grey */
    for (int c = 0; c < 3; c++) assert_true(fabs(rgb[c] - 221) < 2);
    /* The right side's sun sets; with a sky that has one, it darkens. */
    desktop_do(desktop, "key f");
    quit();
    desktop_view(desktop, "\"$here\"/scenes/crater.glsl " SMALL);
    desktop_do(desktop, "key h key v key b mousemove 240 60 mousedown 3 mousemove 240 150 mouseup 3");
    desktop_expect_number(desktop, "samples", 32, 1e9);
    assert_true(desktop_number(desktop, "elevation") == 30);
    assert_true(brightness(20, 4, 100, 60) > 3 * brightness(200, 4, 100, 60));
    /* The divider is dragged to the left: so is the dark. */
    desktop_do(desktop, "mousemove 160 90 mousedown 1 mousemove 100 90 mousemove 15 90 mouseup 1");
    desktop_expect_number(desktop, "samples", 48, 1e9);
    assert_true(brightness(30, 4, 100, 60) < 100);
    assert_true(desktop_number(desktop, "eye_x") == 0);
    quit();
}

static void test_window(void **state) {
    (void)state;
    desktop_view(desktop, "\"$here\"/scenes/crater.glsl " SMALL);
    desktop_do(desktop, "search --name Crater windowsize 401 203");
    desktop_expect_number(desktop, "width", 401, 401);
    desktop_expect_number(desktop, "height", 203, 203);
    desktop_expect_rest(desktop, 16);
    assert_true(brightness(340, 100, 50, 90) > 20);
    desktop_do(desktop, "search --name Crater windowsize 1 1");
    desktop_expect_number(desktop, "width", 1, 1);
    desktop_do(desktop, "search --name Crater windowsize 320 180");
    desktop_expect_number(desktop, "width", 320, 320);
    desktop_do(desktop, "search --name Crater windowunmap");
    desktop_also(desktop, "search --name Crater windowmap");
    desktop_do(desktop, "mousemove 200 100 key i");
    desktop_expect_number(desktop, "samples", 16, 1e9);
    desktop_signal(desktop, SIGINT);
    assert_int_equal(desktop_end(desktop), 0);
    support_expect(2, "usage: magichour view", "view");
    support_expect(3, "no-such.glsl: cannot be read", "view no-such.glsl");
    assert_int_equal(support_run("env -u DISPLAY -u WAYLAND_DISPLAY", "view scenes/crater.glsl"), 4);
    assert_non_null(strstr(support_err, "`magichour render scenes/crater.glsl -o FILE.png`"));
    assert_true(strchr(support_err, '\n') == support_err + strlen(support_err) - 1);
}

/* A day's first frames. */
static void test_record(void **state) {
    (void)state;
    desktop_view(desktop, "\"$here\"/scenes/crater.glsl --size 64x36 --spp 4 --sun 20,0 --record .");
    desktop_expect(desktop, "\"event\": \"recorded\"", "frame-00003");
    desktop_do(desktop, "key t");
    quit();
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
    desktop_view(desktop, "'%s' " SMALL, path);
    desktop_do(desktop, "key h");
    desktop_expect_number(desktop, "samples", 80, 1e9);
    desktop_pixel(desktop, 160, 20, rgb); /* y is up */
    assert_true(abs(rgb[0] - 227) < 4 && abs(rgb[1] - 128) < 3 && abs(rgb[2] - 204) < 3);
    /* A scene that names iTime is given it, and stands still until it is let run. */
    support_write("toy.glsl",
                  "#include \"material/matte.glsl\"\n#include \"shape/plane.glsl\"\n"
                  "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                  "    hit_plane(ray, vec3(0.0, 1.0, 0.0), 0.0, 0, hit);\n}\n"
                  "Material scene_material(Hit hit) { return matte(vec3(iTime < 1.0 ? 0.8 : 0.1)); }\n");
    desktop_expect(desktop, "\"result\": \"good\"", "");
    desktop_do(desktop, "key space key z");
    desktop_expect_rest(desktop, 32);
    double bright = brightness(20, 150, 280, 20);
    desktop_do(desktop, "key space");
    for (double end = clock_seconds() + 20;
         clock_seconds() < end && brightness(20, 150, 280, 20) > 0.7 * bright;)
        usleep(50000);
    assert_true(brightness(20, 150, 280, 20) < 0.7 * bright);
    quit();
}

/* Events at random, and edits between: MAGICHOUR_EVENTS and MAGICHOUR_RELOADS say how many. */
static unsigned dice(unsigned *seed, unsigned sides) {
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 16) % sides;
}

static void random_event(unsigned *seed, Text *script) {
    static const char *const keys[] = {"h",
                                       "v",
                                       "f",
                                       "b",
                                       "x",
                                       "i",
                                       "r",
                                       "c",
                                       "t",
                                       "1",
                                       "2",
                                       "3",
                                       "4",
                                       "Up",
                                       "Down",
                                       "Left",
                                       "Right",
                                       "shift+Up",
                                       "comma",
                                       "period",
                                       "minus",
                                       "equal",
                                       "space",
                                       "z",
                                       "Return",
                                       "5",
                                       "Tab",
                                       "bracketleft",
                                       "bracketright",
                                       "w",
                                       "a",
                                       "s",
                                       "d",
                                       "e",
                                       "q",
                                       "ctrl+c"};
    enum { KEYS = sizeof keys / sizeof *keys };
    unsigned kind = dice(seed, 10);
    if (kind < 5)
        text_print(script, " key %s", keys[dice(seed, KEYS)]);
    else if (kind < 8)
        text_print(script, " mousemove %u %u mousedown %u mousemove %u %u mouseup %u", dice(seed, 330),
                   dice(seed, 190), 1 + kind - 5, dice(seed, 330), dice(seed, 190), 1 + kind - 5);
    else if (kind < 9)
        text_print(script, " click %u", 4 + dice(seed, 2));
    else
        text_print(script, " search --name Edited windowsize %u %u", 1 + dice(seed, 400),
                   1 + dice(seed, 260));
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
    desktop_view(desktop, "'%s' " SMALL " --sun-disk", path);
    for (int done = 0; done < events;) {
        Text script = {0};
        for (int i = 0; i < 10 && done < events; i++, done++) random_event(&seed, &script);
        desktop_do(desktop, "%s", text_string(&script));
        text_free(&script);
        desktop_expect(desktop, "\"event\": \"frame\"", "");
    }
    for (int i = 0; i < reloads; i++) {
        char text[128];
        bool broken = i % 5 == 4;
        snprintf(text, sizeof text, "vec3 tint() { return vec3(%g%s); }\n", 0.1 + 0.004 * (i % 200),
                 broken ? ", " : "");
        desktop_do(desktop, "mousemove %d 20", i % 100);
        support_write("tint.glsl", text);
        desktop_expect(desktop, "\"event\": \"reload\"", broken ? "broken" : "good");
    }
    desktop_signal(desktop, SIGTERM);
    assert_int_equal(desktop_end(desktop), 0);
    assert_null(strstr(desktop_log(desktop), "OpenGL error"));
}

static void test_orbit(void **state) {
    (void)state;
    Scene scene = scene_default("none");
    orbit_turn(&scene, 90, 0);
    assert_true(fabs(scene.eye[0] - 4) < 1e-9 && fabs(scene.eye[1] - 2) < 1e-9 && fabs(scene.eye[2]) < 1e-9);
    orbit_turn(&scene, 0, 1000);
    assert_true(fabs(orbit_distance(&scene) - sqrt(20)) < 1e-9 && scene.eye[1] < -4);
    orbit_zoom(&scene, 0);
    assert_true(orbit_distance(&scene) > 0);
    for (int i = 0; i < 40; i++) orbit_zoom(&scene, 1e3);
    assert_true(orbit_distance(&scene) < 1.1e5);
    for (int i = 0; i < 100; i++) orbit_move(&scene, 1e5, 1e5, 1e5);
    for (int i = 0; i < 3; i++) assert_true(fabs(scene.eye[i]) <= 1e6 && fabs(scene.target[i]) <= 1e6);
    scene_destroy(&scene);
}

/* A day goes through the sun's place of the start, culminates, and leaves out the dark. */
static void test_day_of_the_sun(void **state) {
    (void)state;
    Day day = day_through(20, 200);
    double elevation, azimuth, highest = -90, lowest = 90, length = 0;
    day_sun(&day, &elevation, &azimuth);
    assert_true(fabs(elevation - 20) < 1e-9 && fabs(azimuth - 200) < 1e-9);
    for (; length < 2 * day_length(&day); length += 0.01) {
        day_advance(&day, 0.01);
        day_sun(&day, &elevation, &azimuth);
        highest = fmax(highest, elevation);
        lowest = fmin(lowest, elevation);
        assert_true(azimuth >= 0 && azimuth < 360);
    }
    assert_true(fabs(highest - 60) < 0.01 && lowest > -18.2 && lowest < -17.8);
}

/* What was set stays, what was not follows the file. */
static void test_carry(void **state) {
    (void)state;
    Error error;
    const char *path =
        support_write("carry.glsl", "//@ sun elevation 30\nuniform float a; //@ slider 1 min 0 max 10\n"
                                    "uniform float b; //@ slider 2 min 0 max 10\n");
    const char *edited = support_write("carried.glsl", "//@ sun elevation 40\n//@ exposure 1\n"
                                                       "uniform float b; //@ slider 3 min 0 max 4\n"
                                                       "uniform float a; //@ slider 5 min 0 max 10\n");
    Scene file, next;
    assert_true(scene_read(&file, path, &error) && scene_read(&next, edited, &error));
    Scene current = file;
    assert_true(scene_set(&current, "b", "9", &error) && scene_set(&current, "sun.azimuth", "7", &error));
    assert_true(scene_set(&current, "atmosphere.mie", "0.5", &error));
    carry_over(&next, &file, &current);
    assert_true(next.parameters[0].value[0] == 4 && next.parameters[1].value[0] == 5);
    assert_true(next.sun_elevation_deg == 40 && next.sun_azimuth_deg == 7 && next.exposure_ev == 1);
    assert_true(next.atmosphere.mie == 0.5 && next.atmosphere.rayleigh == 1);
    scene_destroy(&file);
    scene_destroy(&next);
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
    for (const char *at = desktop_log(desktop) + from;
         (at = strstr(at, "\"latency_ms\": ")) && count < MOST_TIMES; at++) {
        sscanf(at, "\"latency_ms\": %lf", &times[count]);
        count += times[count] > 0;
    }
    print_times("from an event to its picture", times, count);
}

/* From a key to another pixel on the screen, with the time that xdotool takes to start. */
static void measure_latency(void) {
    enum { TIMES = 15 };
    double times[TIMES];
    for (int i = 0; i < TIMES; i++) {
        double before[3], now[3];
        usleep(1200000);
        desktop_mean(desktop, 300, 20, 4, 4, before);
        double start_s = clock_seconds();
        desktop_do(desktop, "key --delay 0 %d", i % 2 ? 3 : 1);
        do desktop_mean(desktop, 300, 20, 4, 4, now);
        while (fabs(now[0] - before[0]) < 3 && clock_seconds() < start_s + 2);
        times[i] = 1e3 * (clock_seconds() - start_s);
    }
    print_times("from xdotool's start to another pixel on the screen", times, TIMES);
}

/* Not a test: figures of this machine, for the scene and the size that are given. */
static int measure(const char *scene, const char *size) {
    double seconds = 3;
    void *state = NULL;
    if (support_folder(&state) != 0) return 1;
    desktop = desktop_start();
    desktop_view(desktop, "\"$here\"/%s --size %s", scene, size);
    usleep(2000000);
    Text script = {0};
    text_print(&script, "mousemove 500 100 mousedown 3");
    for (int i = 0; i < seconds / 0.015; i++)
        text_print(&script, " mousemove 500 %d sleep 0.015", 100 + i % 100);
    size_t log = strlen(desktop_log(desktop));
    double frames = desktop_number(desktop, "frame"), from = clock_seconds();
    desktop_do(desktop, "%s", text_string(&script));
    frames = desktop_number(desktop, "frame") - frames;
    printf("%s %s: %.1f updates a second while the sun is dragged, 1 / %.0f of the size\n", scene, size,
           frames / (clock_seconds() - from), desktop_number(desktop, "coarseness"));
    measure_answers(log);
    desktop_do(desktop, "mouseup 3");
    usleep(2000000);
    printf("after 2 s of rest: %.0f samples\n", desktop_number(desktop, "samples"));
    measure_latency();
    text_free(&script);
    quit();
    desktop_stop(desktop);
    return support_clean(&state);
}

int main(int argc, char **argv) {
    if (argc > 3 && strcmp(argv[1], "measure") == 0) return measure(argv[2], argv[3]);
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_orbit),
        cmocka_unit_test(test_day_of_the_sun),
        cmocka_unit_test(test_carry),
        cmocka_unit_test_setup_teardown(test_sun, start, stop),
        cmocka_unit_test_setup_teardown(test_day, start, stop),
        cmocka_unit_test_setup_teardown(test_camera, start, stop),
        cmocka_unit_test_setup_teardown(test_reload, start, stop),
        cmocka_unit_test_setup_teardown(test_save, start, stop),
        cmocka_unit_test_setup_teardown(test_sides, start, stop),
        cmocka_unit_test_setup_teardown(test_window, start, stop),
        cmocka_unit_test_setup_teardown(test_record, start, stop),
        cmocka_unit_test_setup_teardown(test_shadertoy, start, stop),
        cmocka_unit_test_setup_teardown(test_storm, start, stop),
    };
    return cmocka_run_group_tests(tests, support_folder, support_clean);
}
