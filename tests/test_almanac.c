/* The sun by place and time, against two independent almanacs: tests/data/almanac.csv has rows by XEphem's
 * library (PyEphem 4.2.1) and by the Solar Position Algorithm of the National Renewable Energy Laboratory
 * (pvlib), both without refraction. */
#include "support.h"

#include "base/vec3.h"
#include "scene/scene.h"
#include "scene/sun_clock.h"
#include "scene/sun_day.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double promised_deg = 0.02;

static double apart(const SunPlace *a, double elevation_deg, double azimuth_deg) {
    double x = a->elevation_deg * degree, y = elevation_deg * degree;
    double turn = (a->azimuth_deg - azimuth_deg) * degree;
    double chord = pow(sin((x - y) / 2), 2) + cos(x) * cos(y) * pow(sin(turn / 2), 2);
    return 2 * asin(fmin(sqrt(chord), 1)) / degree;
}

static void test_rows(void **state) {
    (void)state;
    char line[256], when[32];
    double worst = 0;
    int rows = 0;
    FILE *file = fopen("tests/data/almanac.csv", "r");
    assert_non_null(file);
    assert_non_null(fgets(line, sizeof line, file));
    while (fgets(line, sizeof line, file)) {
        Place place;
        double expected[4];
        Moment moment;
        Error error;
        assert_int_equal(sscanf(line, "%31[^,],%lf,%lf,%lf,%lf,%lf,%lf,%lf", when, &place.latitude_deg,
                                &place.longitude_deg, &place.height_m, &expected[0], &expected[1],
                                &expected[2], &expected[3]),
                         8);
        if (!moment_parse("row", when, &moment, &error)) fail_msg("%s", error.text);
        SunPlace sun = almanac_sun(moment.utc_s, &place);
        for (int i = 0; i < 2; i++) {
            double off = apart(&sun, expected[2 * i], expected[2 * i + 1]);
            worst = fmax(worst, off);
            if (off > promised_deg) fail_msg("%s is off by %g degrees", line, off);
        }
        rows++;
    }
    fclose(file);
    print_message("%d rows, off by at most %.4f degrees\n", rows, worst);
    assert_true(rows >= 50);
}

/* The example of the Solar Position Algorithm (Reda and Andreas 2004, table A5.1), without its refraction.
 * Its sunrise is at 06:12:43. Its sunset is that of the day before, because it goes by the day of UTC;
 * PyEphem has 17:18:51. */
static void test_example(void **state) {
    (void)state;
    Moment moment;
    Error error;
    Passage passages[MOST_PASSAGES];
    Place place = {39.742476, -105.1786, 1830.14};
    assert_true(moment_parse("example", "2003-10-17T12:30:30-07:00", &moment, &error));
    SunPlace sun = almanac_sun(moment.utc_s, &place);
    assert_true(apart(&sun, 39.872046, 194.340241) < 1e-3);
    SunDay day = sun_day(&moment, &place);
    assert_int_equal(sun_day_passages(&day, sunrise_elevation_deg, passages), 2);
    static const double expected_s[] = {6 * 3600 + 12 * 60 + 43, 17 * 3600 + 18 * 60 + 51};
    for (int i = 0; i < 2; i++) {
        double seconds = passages[i].utc_s - day.midnight.utc_s;
        print_message("%s %.0f s after midnight, expected %.0f\n", passages[i].rising ? "sunrise" : "sunset",
                      seconds, expected_s[i]);
        assert_true(passages[i].rising == (i == 0) && fabs(seconds - expected_s[i]) < 5);
    }
}

/* Summer at Spitsbergen has no sunset, winter no sunrise, and the sun is highest in the south or the north.
 */
static void test_days(void **state) {
    (void)state;
    static const struct {
        const char *when;
        Place place;
        int passages;
        double highest_deg;
    } cases[] = {{"2026-06-21T12:00Z", {78.2, 15.6, 0}, 0, 35.24},
                 {"2026-12-21T12:00Z", {78.2, 15.6, 0}, 0, -11.64},
                 {"2026-03-20T12:00Z", {0, 0, 0}, 2, 90},
                 {"2026-06-21T12:00+10:00", {-33.87, 151.21, 0}, 2, 32.69}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Moment moment;
        Error error;
        Passage passages[MOST_PASSAGES];
        assert_true(moment_parse("case", cases[i].when, &moment, &error));
        SunDay day = sun_day(&moment, &cases[i].place);
        assert_int_equal(sun_day_passages(&day, sunrise_elevation_deg, passages), cases[i].passages);
        if (fabs(day.highest_deg - cases[i].highest_deg) > 0.2)
            fail_msg("%s: highest %g", cases[i].when, day.highest_deg);
    }
}

static void test_refraction(void **state) {
    (void)state;
    /* The Astronomical Almanac's: 34 minutes at the horizon, where the true sun is that much below, 5.3 at 10
     * degrees, 1.0 at 45, 0 at the zenith. */
    assert_true(fabs(sun_refraction_deg(-0.575) * 60 - 34.5) < 1);
    assert_true(fabs(sun_refraction_deg(10) * 60 - 5.35) < 0.1);
    assert_true(fabs(sun_refraction_deg(45) * 60 - 1) < 0.03);
    assert_true(sun_refraction_deg(90) < 1e-4 && sun_refraction_deg(-30) == 0);
}

static void test_moments(void **state) {
    (void)state;
    static const struct {
        const char *text;
        double utc_s;
    } good[] = {{"1970-01-01T00:00Z", 0},
                {"1970-01-01T00:00:01Z", 1},
                {"2000-03-01T00:00Z", 951868800},
                {"2026-06-21T20:30+02:00", 1782066600},
                {"2026-06-21 20:30+0200", 1782066600},
                {"1969-12-31T19:30-05:30", 3600},
                {"1950-01-01T00:00Z", -631152000}};
    static const char *const bad[][2] = {{"", "date"},
                                         {"21.6.2026 20:30", "date"},
                                         {"2026-06-21", "time"},
                                         {"2026-06-21T", "time"},
                                         {"2026-06-21T2030Z", "time"},
                                         {"2026-06-21T20:30", "zone"},
                                         {"2026-06-21T20:30 CEST", "zone"},
                                         {"2026-06-21T20:30+2", "zone"},
                                         {"2026-06-21T20:30+02:00x", "zone"},
                                         {"2026-13-21T20:30Z", "month 13"},
                                         {"2026-02-29T20:30Z", "day 29"},
                                         {"2026-06-21T24:30Z", "hour 24"},
                                         {"2026-06-21T20:60Z", "minute 60"},
                                         {"1815-06-18T11:35Z", "year 1815"}};
    Moment moment;
    Error error;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        if (!moment_parse("good", good[i].text, &moment, &error)) fail_msg("%s", error.text);
        if (moment.utc_s != good[i].utc_s) fail_msg("%s: %.0f", good[i].text, moment.utc_s);
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_false(moment_parse("bad", bad[i][0], &moment, &error));
        if (!strstr(error.text, bad[i][1])) fail_msg("'%s': %s", bad[i][0], error.text);
    }
    Text text = {0};
    assert_true(moment_parse("leap", "2024-02-29T23:59-05:30", &moment, &error));
    moment_print_date(&moment, &text);
    moment_print_time(&moment, &text);
    moment_print_zone(&moment, &text);
    assert_string_equal(text_string(&text), "2024-02-2923:59-05:30");
    text_free(&text);
}

/* In the scene's frame, with y up and +z to the north, east is -x: the evening's sun stands in the west,
 * toward +x. */
static void test_scene(void **state) {
    (void)state;
    Error error;
    const char *path =
        support_write("clock.glsl", "//@ sun when 2026-06-21T20:30+02:00 where 48.14,11.58\n//@ preset noon "
                                    "sun.when 2026-06-21T13:15+02:00\n"
                                    "//@ preset low sun.elevation 3\n");
    Scene scene;
    if (!scene_read(&scene, path, "glsl", &error)) fail_msg("%s", error.text);
    const Sun *sun = &scene.values.sun;
    assert_true(fabs(sun->elevation_deg - 5.78) < 0.02 && fabs(sun->azimuth_deg - 60.92) < 0.02);
    assert_true(sun->direction[0] > 0.8 && sun->direction[2] > 0.4);
    assert_true(scene_set(&scene, "sun.north", "90", &error) && fabs(sun->azimuth_deg - 150.92) < 0.02);
    assert_true(scene_choose_preset(&scene, "noon", &error) && fabs(sun->elevation_deg - 65.3) < 0.02);
    assert_true(scene_choose_preset(&scene, "low", &error) && sun->elevation_deg == 3);
    assert_false(sun_clock_runs(&scene.values.clock));
    scene_destroy(&scene);
    const char *both =
        support_write("both.glsl", "//@ sun elevation 5\n//@ sun when 2026-06-21T20:30Z where 1,2\n");
    assert_false(scene_read(&scene, both, "glsl", &error));
    assert_non_null(strstr(error.text, "both.glsl:2: sun: elevation and azimuth say"));
}

static void test_command_line(void **state) {
    (void)state;
    support_expect(0, "", "info --when 2026-06-21T20:30+02:00 --where 48.14,11.58");
    static const char *const said[] = {"the sun on 2026-06-21 20:30 +02:00 at 48.14, 11.58, 0 m high",
                                       "elevation   5.78 degrees",
                                       "with it 5.93",
                                       "azimuth     299.08",
                                       "sunrise     05:13",
                                       "sunset      21:17",
                                       "golden hour 04:48 to 06:02, 20:28 to 21:42",
                                       "blue hour   04:31 to 04:48, 21:42 to 21:59"};
    for (size_t i = 0; i < sizeof said / sizeof *said; i++) {
        if (!strstr(support_out, said[i])) fail_msg("no '%s' in\n%s", said[i], support_out);
    }
    support_expect(STATUS_USAGE, "magichour: --where: latitude: 98.2 is outside",
                   "info --when 2026-06-21T20:30Z --where 98.2,1");
    support_expect(STATUS_USAGE, "magichour: --where: '8' is not LATITUDE,LONGITUDE",
                   "info --when 2026-06-21T20:30Z --where 8");
    support_expect(STATUS_USAGE, "magichour: --where: '1,2,3,4' is not",
                   "info --when 2026-06-21T20:30Z --where 1,2,3,4");
    support_expect(STATUS_USAGE, "magichour: a time says where the sun stands only together with a place",
                   "info --when 2026-06-21T20:30Z");
    support_expect(STATUS_USAGE, "magichour: --where says", "info --where 1,2");
    support_expect(STATUS_USAGE, "magichour: --sun says where",
                   "sky -o '%s' --when 2026-06-21T20:30Z --where 1,2 --sun 3", support_path("a.pfm"));
    /* The same sun by its angles makes the same picture. */
    const char *a = support_path("a.pfm"), *b = support_path("b.pfm");
    support_expect(0, "",
                   "sky -o '%s' --size 64x32 --when 2026-06-21T20:30+02:00 --where 48.14,11.58 --quiet", a);
    Place place = {48.14, 11.58, 0};
    SunPlace sun = almanac_sun(1782066600, &place);
    support_expect(0, "", "sky -o '%s' --size 64x32 --sun %.17g,%.17g --quiet", b, sun.elevation_deg,
                   360 - sun.azimuth_deg);
    support_expect(0, "", "compare '%s' '%s' --max-relrmse 0.001", a, b);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_rows),        cmocka_unit_test(test_example),
                                       cmocka_unit_test(test_days),        cmocka_unit_test(test_refraction),
                                       cmocka_unit_test(test_moments),     cmocka_unit_test(test_scene),
                                       cmocka_unit_test(test_command_line)};
    return cmocka_run_group_tests_name("almanac", tests, support_folder, support_clean);
}
