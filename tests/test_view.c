/* What of the window needs no window: the camera's orbit, the day, what an edit carries over, figures in
 * words. */
#include "support.h"

#include "base/lines.h"
#include "scene/almanac.h"
#include "view/carry.h"
#include "view/day.h"
#include "view/exposure.h"
#include "view/figures.h"
#include "view/keys.h"
#include "view/meter.h"
#include "view/orbit.h"
#include "view/remember.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void test_orbit(void **state) {
    (void)state;
    Scene scene = scene_default("none", "glsl");
    orbit_turn(&scene, 90, 0);
    assert_true(fabs(scene.values.camera.eye[0] - 4) < 1e-9 && fabs(scene.values.camera.eye[1] - 2) < 1e-9 &&
                fabs(scene.values.camera.eye[2]) < 1e-9);
    orbit_turn(&scene, 0, 1000);
    assert_true(fabs(orbit_distance(&scene) - sqrt(20)) < 1e-9 && scene.values.camera.eye[1] < -4);
    orbit_zoom(&scene, 0);
    assert_true(orbit_distance(&scene) > 0);
    for (int i = 0; i < 40; i++) orbit_zoom(&scene, 1e3);
    assert_true(orbit_distance(&scene) < 1.1e5);
    for (int i = 0; i < 100; i++) orbit_move(&scene, 1e5, 1e5, 1e5);
    for (int i = 0; i < 3; i++)
        assert_true(fabs(scene.values.camera.eye[i]) <= 1e6 && fabs(scene.values.camera.target[i]) <= 1e6);
    scene_destroy(&scene);
}

/* A day goes through the sun's place of the start, culminates, and leaves out the dark. */
static void test_day_of_the_sun(void **state) {
    (void)state;
    Scene scene = scene_default("test", "glsl");
    scene_set_sun(&scene, 20, 200);
    const Sun *sun = &scene.values.sun;
    Day day = day_of(&scene.values);
    double highest = -90, lowest = 90, length = 0;
    day_apply(&day, &scene.values);
    assert_true(fabs(sun->elevation_deg - 20) < 1e-9 && fabs(sun->azimuth_deg - 200) < 1e-9);
    for (; length < 2 * day_length(&day); length += 0.01) {
        day_advance(&day, 0.01);
        day_apply(&day, &scene.values);
        highest = fmax(highest, sun->elevation_deg);
        lowest = fmin(lowest, sun->elevation_deg);
        assert_true(sun->azimuth_deg >= 0 && sun->azimuth_deg < 360);
    }
    assert_true(fabs(highest - 60) < 0.01 && lowest > -18.2 && lowest < -17.8);
    scene_destroy(&scene);
}

/* The real day of a place: its noon, and a night whose dark part is left out. The dark lasts 13.5 hours in
 * Munich at the winter solstice, so that the day is played in less than 14. */
static void test_real_day(void **state) {
    (void)state;
    Scene scene = scene_default("test", "glsl");
    Error error;
    if (almanac_missing()) skip();
    assert_true(scene_set(&scene, "sun.where", "48.14,11.58", &error));
    assert_true(scene_set(&scene, "sun.when", "2026-12-21T12:00+01:00", &error));
    const Sun *sun = &scene.values.sun;
    Day day = day_of(&scene.values);
    double highest = -90, lowest = 90, begin = scene.values.clock.utc_s, played = day_length(&day);
    assert_true(played > 11 && played < 13);
    for (double length = 0; length < played; length += 0.01) {
        day_advance(&day, 0.01);
        day_apply(&day, &scene.values);
        highest = fmax(highest, sun->elevation_deg);
        lowest = fmin(lowest, sun->elevation_deg);
    }
    assert_true(fabs(highest - 18.42) < 0.02 && lowest > -18.3 && lowest < -17.7);
    assert_true(fabs(scene.values.clock.utc_s - begin - 86400) < 1200);
    /* A sun that is moved by hand leaves the real day. */
    scene_set_sun(&scene, 20, 200);
    day = day_of(&scene.values);
    day_apply(&day, &scene.values);
    assert_true(fabs(sun->elevation_deg - 20) < 1e-9);
    scene_destroy(&scene);
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
    assert_true(scene_read(&file, path, "glsl", &error) && scene_read(&next, edited, "glsl", &error));
    Scene current = file;
    assert_true(scene_set(&current, "b", "9", &error) && scene_set(&current, "sun.azimuth", "7", &error));
    assert_true(scene_set(&current, "atmosphere.mie", "0.5", &error));
    carry_over(&next, &file, &current);
    assert_true(next.values.parameters[0][0] == 4 && next.values.parameters[1][0] == 5);
    assert_true(next.values.sun.elevation_deg == 40 && next.values.sun.azimuth_deg == 7 &&
                next.values.exposure_ev == 1);
    assert_true(next.values.atmosphere.mie == 0.5 && next.values.atmosphere.rayleigh == 1);
    scene_destroy(&file);
    scene_destroy(&next);
}

/* A curve's ends stand in opposite corners, and a straight line halves where the time quadruples; when it is
 * full, it becomes coarser. */
static void test_curve(void **state) {
    (void)state;
    ErrorCurve curve = {.count = 0};
    double place[2];
    curve_extend(&curve, 1, NAN);
    curve_extend(&curve, 1, 0);
    for (double seconds = 1; seconds < 5; seconds *= 4) curve_extend(&curve, seconds, 8 / sqrt(seconds));
    curve_extend(&curve, 4.1, 4);
    curve_extend(&curve, 16, 2);
    assert_int_equal(curve.count, 3);
    for (int i = 0; i < 3; i++) {
        curve_place(&curve, i, place);
        assert_true(fabs(place[0] - 0.5 * i) < 1e-9 && fabs(place[1] - 0.5 * i) < 1e-9);
    }
    for (int i = 0; i < 1000; i++) curve_extend(&curve, 16 * pow(1.06, i), 2 * pow(1.06, -0.5 * i));
    assert_true(curve.count > MOST_CURVE / 4 && curve.count <= MOST_CURVE && curve.seconds[0] == 1);
    for (int i = 1; i < curve.count; i++) assert_true(curve.seconds[i] > curve.seconds[i - 1]);
}

static void test_words(void **state) {
    (void)state;
    SideFigures side = {.methods = "table, cosine",
                        .samples = 80,
                        .seconds = 2.2,
                        .prepared = 1,
                        .coarseness = 1,
                        .paths_per_second = 7.2e6,
                        .error_percent = 1.04,
                        .error_levels = 2.31,
                        .worst_levels = 5.12};
    PixelFigures pixel = {.known = true, .x = 3, .y = 4, .place = 2};
    char text[320];
    figures_side(&side, text, sizeof text);
    assert_string_equal(text, "table, cosine\n80 samples in 2.2 s, 7.2 Mpaths/s\nerror about 1.04 %\n"
                              "2.3 of 255 levels, 5.1 in the worst tile");
    side.error_levels = NAN;
    figures_levels(&side, text, sizeof text);
    assert_string_equal(text, "");
    side.error_percent = NAN;
    figures_error(&side, text, sizeof text);
    assert_string_equal(text, "error not yet known");
    side.coarseness = 4;
    figures_progress(&side, text, sizeof text);
    assert_string_equal(text, "preview, 1/4 of the size");
    side.prepared = 0.408;
    figures_progress(&side, text, sizeof text);
    assert_string_equal(text, "computing the sky, 40 %");
    figures_pixel(&pixel, text, sizeof text);
    assert_true(strstr(text, "pixel 3 4, right side\n") == text && strstr(text, "depth     none"));
}

/* What is less important is left out of a bar that is too long. */
static void test_bar(void **state) {
    (void)state;
    ViewFigures figures = {.scene = true, .frame_mean_s = 0.04};
    Sun sun = sun_at(-4, 90, 0.27);
    char text[200];
    figures.sides[0] =
        (SideFigures){.samples = 80, .seconds = 2.2, .prepared = 1, .coarseness = 1, .error_percent = 1.04};
    figures_bar(&figures, &sun, 100, text, sizeof text);
    assert_string_equal(text, "80 samples in 2.2 s   error 1.04 %   sun -4 90   25 fps");
    figures_bar(&figures, &sun, 37, text, sizeof text);
    assert_string_equal(text, "80 samples in 2.2 s   error 1.04 %");
    figures_bar(&figures, &sun, 5, text, sizeof text);
    assert_string_equal(text, "");
    figures.scene = false;
    figures_bar(&figures, &sun, 100, text, sizeof text);
    assert_string_equal(text, "frame 80   25 fps");
}

/* The place follows the XDG standard, which ignores a path that is not absolute; folders are made, and where
 * none can be made nothing happens. */
static void test_remember(void **state) {
    (void)state;
    char *home = strdup(support_path("home")), wanted[600];
    setenv("HOME", home, 1);
    setenv("XDG_STATE_HOME", "relative", 1);
    char *path = remember_path();
    snprintf(wanted, sizeof wanted, "%s/.local/state/magichour/window.ini", home);
    assert_string_equal(path, wanted);
    assert_false(remember_exists(path));
    remember_write(path, "text");
    assert_true(remember_exists(path));
    free(path);
    setenv("XDG_STATE_HOME", wanted, 1);
    path = remember_path();
    remember_write(path, "text");
    assert_false(remember_exists(path));
    free(path);
    unsetenv("HOME");
    unsetenv("XDG_STATE_HOME");
    assert_null(remember_path());
    free(home);
}

enum { CELLS = METER_COLUMNS * METER_ROWS };

static double reading_of(double light, double sun, int sun_cells, int black_cells) {
    float cells[4 * CELLS];
    for (int i = 0; i < 4 * CELLS; i++) {
        int cell = i / 4;
        cells[i] = (float)(cell < sun_cells ? sun : cell >= CELLS - black_cells ? 0 : light);
    }
    return meter_reading(cells);
}

/* The meter reads stops. The sun's own image does not count, nor a little black, and black alone is no
 * reading.
 */
static void test_meter(void **state) {
    (void)state;
    assert_true(fabs(reading_of(0.25, 0, 0, 0) + 2) < 1e-6);
    assert_true(fabs(reading_of(8, 0, 0, 0) - 3) < 1e-6);
    assert_true(fabs(reading_of(0.25, 3e5, CELLS / 30, 0) + 2) < 1e-6);
    assert_true(fabs(reading_of(0.25, 0, 0, CELLS / 30) + 2) < 1e-6);
    assert_true(reading_of(0.25, 0, 0, CELLS / 2) < -5 && reading_of(0.25, 0, 0, CELLS / 2) > -8);
    assert_true(isnan(reading_of(0, 0, 0, 0)) && isnan(reading_of(NAN, 0, 0, 0)));
}

/* At the anchor the exposure is the author's, whatever the meter reads. A darker picture gets nine tenths of
 * what it lost, within limits, and the way back ends where it began. */
static void test_exposure(void **state) {
    (void)state;
    Scene scene = scene_default("none", "glsl");
    SceneValues own = scene.values, night = own;
    AutoExposure exposure = {.on = true, .target_ev = NAN};
    double shown_ev = 0;
    night.sun.elevation_deg = -4;
    night.exposure_ev = 7;
    assert_false(exposure_adapt(&exposure, &shown_ev, 1));
    own.exposure_ev = -1;
    exposure_anchor(&exposure, &own);
    assert_false(exposure_adapt(&exposure, &shown_ev, 0.01));
    assert_true(shown_ev == -1);
    exposure_read(&exposure, &own, -3);
    assert_true(exposure.target_ev == -1);
    exposure_read(&exposure, &night, -8);
    assert_true(fabs(exposure.target_ev - 3.5) < 1e-9);
    double before = shown_ev;
    assert_true(exposure_adapt(&exposure, &shown_ev, 0.02) && shown_ev > before && shown_ev < 0);
    for (int i = 0; i < 100; i++) exposure_adapt(&exposure, &shown_ev, 0.02);
    assert_true(shown_ev == exposure.target_ev);
    exposure_read(&exposure, &night, -40);
    assert_true(fabs(exposure.target_ev - 13) < 1e-9);
    exposure_read(&exposure, &night, NAN);
    assert_true(fabs(exposure.target_ev - 13) < 1e-9);
    exposure_read(&exposure, &own, -2.9);
    assert_true(exposure.target_ev == -1);
    /* Without an anchor a picture of middle grey is shown as it is. */
    exposure = (AutoExposure){.on = true, .target_ev = NAN};
    exposure_read(&exposure, &night, log2(0.18));
    assert_true(fabs(exposure.target_ev) < 1e-9);
    scene_destroy(&scene);
}

/* An edit of the author's exposure moves the anchor's by as much, and a scene that was shown as its author
 * meant is shown so afterwards. */
static void test_exposure_of_an_edit(void **state) {
    (void)state;
    Scene scene = scene_default("none", "glsl");
    SceneValues before = scene.values, now = before;
    AutoExposure exposure = {.on = true, .target_ev = NAN};
    exposure_anchor(&exposure, &before);
    exposure_read(&exposure, &before, -2);
    now.exposure_ev = 1;
    now.camera.eye[1] += 1;
    exposure_reload(&exposure, &before, &now, &now, true);
    assert_true(exposure_is_anchor(&exposure, &now) && !exposure_is_anchor(&exposure, &before));
    exposure_read(&exposure, &now, -2);
    assert_true(exposure.target_ev == 1);
    scene_destroy(&scene);
}

/* The README has the keys as the window's own help has them, in the same order, beside the marks of code. */
static void test_help(void **state) {
    (void)state;
    Error error;
    Text text = {0}, plain = {0}, expected = {0};
    assert_true(lines_read("src/view/README.md", STATUS_FAILURE, &text, &error));
    for (const char *c = text_string(&text); *c; c++) {
        if (*c != '`') text_append(&plain, c, 1);
    }
    text_print(&expected, "| keys | what they do |\n|---|---|\n");
    for (int i = 0; keys_help(i); i++) {
        text_print(&expected, "| %s | ", keys_help(i)->keys);
        for (const char *c = keys_help(i)->what; *c; c++) {
            if (*c != '`') text_append(&expected, c, 1);
        }
        text_print(&expected, " |\n");
    }
    text_print(&expected, "\n");
    if (!strstr(text_string(&plain), text_string(&expected)))
        fail_msg("src/view/README.md has not these keys:\n%s", text_string(&expected));
    text_free(&text);
    text_free(&plain);
    text_free(&expected);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_orbit),
        cmocka_unit_test(test_day_of_the_sun),
        cmocka_unit_test(test_real_day),
        cmocka_unit_test(test_carry),
        cmocka_unit_test(test_meter),
        cmocka_unit_test(test_exposure),
        cmocka_unit_test(test_exposure_of_an_edit),
        cmocka_unit_test(test_bar),
        cmocka_unit_test(test_remember),
        cmocka_unit_test(test_help),
        cmocka_unit_test(test_curve),
        cmocka_unit_test(test_words),
    };
    return cmocka_run_group_tests_name("view", tests, support_folder, support_clean);
}
