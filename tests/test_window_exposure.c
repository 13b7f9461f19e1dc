/* The window's automatic exposure, by real events: what it shows, and that it changes nothing that is saved.
 */
#include "desktop.h"

#include "base/file.h"
#include "image/exr_attribute.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define CRATER "\"$here\"/scenes/crater.glsl --size 320x180 --sky gauss:4"

static double brightness(void) {
    double rgb[3];
    desktop_mean(window, 0, 0, 320, 180, rgb);
    return (rgb[0] + rgb[1] + rgb[2]) / 3;
}

static double settled_exposure(void) {
    double before, now = NAN;
    desktop_expect_samples(window, 64);
    do {
        before = now;
        desktop_settle(window);
        now = desktop_number(window, "exposure");
    } while (now != before);
    return now;
}

/* A sun that was typed below the horizon leaves a picture that is well lit, the way back ends at the author's
 * exposure, and what is saved is the radiance that `render` makes. */
static void test_night(void **state) {
    (void)state;
    Text command = {0}, file = {0};
    Error error;
    char shown[64];
    desktop_view(window, CRATER " --spp 64");
    desktop_do(window, "key h mousemove 700 500");
    desktop_settle(window);
    assert_true(desktop_number(window, "exposure") == 0);
    double day = brightness();
    desktop_do(window, "key Return key minus key 4 key Return");
    double night_ev = settled_exposure(), night = brightness();
    assert_true(night_ev > 4 && night_ev < 7);
    assert_true(night > 0.5 * day && night < 1.2 * day);
    const char *saved = desktop_save(window, "exr");
    assert_true(file_read(saved, STATUS_FAILURE, &file, &error));
    assert_true(exr_attribute(&file, "magichour.command", &command));
    char *output = strstr(command.data, "-o picture.exr ");
    assert_non_null(output);
    memset(output, ' ', strlen("-o picture.exr "));
    snprintf(shown, sizeof shown, " --exposure %.6g", night_ev);
    assert_non_null(strstr(command.data, shown));
    assert_int_equal(
        support_run("", "%s --quiet -o '%s'", command.data + strlen("magichour "), support_path("again.exr")),
        0);
    assert_int_equal(support_run("", "compare '%s' '%s' --max-relrmse 0", saved, support_path("again.exr")),
                     0);
    text_free(&command);
    text_free(&file);
    desktop_do(window, "key Return key 3 key 0 key Return");
    assert_true(settled_exposure() == 0);
    desktop_do(window, "key Return key minus key 4 key Return");
    assert_true(fabs(settled_exposure() - night_ev) < 0.11);
    desktop_quit(window);
}

/* Who sets an exposure keeps it, until the automatic one is asked for. */
static void test_by_hand(void **state) {
    (void)state;
    desktop_view(window, CRATER " --exposure 1 --sun -4");
    assert_true(settled_exposure() == 1);
    desktop_do(window, "key m");
    desktop_expect_number(window, "exposure", 4, 7);
    double night_ev = settled_exposure();
    assert_true(night_ev > 4 && desktop_number(window, "exposure_automatic") == 1);
    desktop_do(window, "key equal");
    desktop_expect_number(window, "exposure", night_ev + 0.25, night_ev + 0.25);
    desktop_do(window, "key 1");
    assert_true(settled_exposure() == 1 && desktop_number(window, "exposure_automatic") == 0);
    desktop_quit(window);
    desktop_view(window, CRATER " --set exposure=2");
    assert_true(settled_exposure() == 2);
    desktop_quit(window);
}

/* The sun's own image does not darken a picture of the sky around it. */
static void test_sun(void **state) {
    (void)state;
    double plain = 0;
    for (int disk = 0; disk < 2; disk++) {
        desktop_view(window, CRATER " --sun 45,0 %s --set camera.target=0,7,0", disk ? "--sun-disk" : "");
        double exposure_ev = settled_exposure();
        if (disk) assert_true(fabs(exposure_ev - plain) < 0.11);
        plain = exposure_ev;
        desktop_quit(window);
    }
}

/* A recorded day has an exposure for each frame: that of its own picture, at once. */
static void test_record(void **state) {
    (void)state;
    desktop_view(window, CRATER " --spp 4 --sun -2,0 --record .");
    desktop_expect(window, "\"event\": \"recorded\"", "frame-00003");
    assert_true(desktop_largest(window, "exposure") > 3);
    desktop_do(window, "key t");
    desktop_quit(window);
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_night, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_by_hand, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_sun, desktop_setup, desktop_teardown),
        cmocka_unit_test_setup_teardown(test_record, desktop_setup, desktop_teardown),
    };
    return cmocka_run_group_tests_name("window_exposure", tests, support_folder, support_clean);
}
