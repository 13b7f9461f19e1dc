/* What the sky's methods are said to err, at heights and suns of the scan (tools/bias_scan.sh). The scan
 * takes hours; this is a sample of it. */
#include "support.h"

#include "choice/bias.h"
#include "sky/sky_probe.h"
#include "sky/sky_truth.h"

#include <math.h>

/* Directions over the whole sky, and as many about the horizon. */
enum { DIRECTIONS = 768, BOTH = 2 * DIRECTIONS };

static const double heights[] = {30,    600,   1001,  2000,  8000,  12000, 16000, 20000, 30000,  45000,
                                 55000, 58000, 58500, 59000, 59800, 60000, 60050, 66000, 100000, 1000000};
static const double suns[] = {90, 30, 15, 7, 3, 1.5, 0.75, 0.3, 0, -0.2, -0.7, -1.5, -2.5, -4, -6, -8, -10};
enum { HEIGHTS = sizeof heights / sizeof *heights, SUNS = sizeof suns / sizeof *suns };

/* The larger relRMSE, percent, of the sky and of its horizon. */
static double error_percent(const float *got, const float *wanted) {
    double error[2];
    for (int set = 0; set < 2; set++) {
        double squares = 0, sum = 0;
        for (int i = 4 * set * DIRECTIONS; i < 4 * (set + 1) * DIRECTIONS; i++) {
            if (i % 4 == 3) continue;
            squares += pow((double)got[i] - (double)wanted[i], 2);
            sum += (double)wanted[i];
        }
        error[set] = 100 * sqrt(squares * 3 * DIRECTIONS) / sum;
    }
    return fmax(error[0], error[1]);
}

/* As tools/bias.sh has them: without the ground up to 1 km, and 20 degrees about the visible horizon. */
static void spread(const SkyState *sky, float *directions) {
    double horizon = sky_horizon_sine(&sky->atmosphere), middle = asin(horizon), degree = atan(1) / 45;
    bool ground = sky->atmosphere.observer_height_m > 1000;
    for (int i = 0; i < BOTH; i++) {
        bool about = i >= DIRECTIONS;
        double low = !ground ? horizon
                     : about ? sin(fmax(middle - 20 * degree, -90 * degree))
                             : -1,
               high = about ? sin(middle + 20 * degree) : 1,
               y = low + (high - low) * (i % DIRECTIONS + 0.5) / DIRECTIONS, azimuth = 2.39996323 * (i + 0.5);
        directions[4 * i] = (float)(sqrt(1 - y * y) * sin(azimuth));
        directions[4 * i + 1] = (float)y;
        directions[4 * i + 2] = (float)(sqrt(1 - y * y) * cos(azimuth));
    }
}

static void open_probe(SkyProbe *probe, const Context *context, const char *method, const Atmosphere *air) {
    MethodChoice choice;
    Error error;
    if (!method_choose(&choice, METHOD_SKY, method, &error) ||
        !sky_probe_create(probe, context, support_sources(), &choice, air, &error))
        fail_msg("%s", error.text);
}

static void ask(SkyProbe *probe, const SkyState *sky, float *radiances) {
    static float directions[4 * BOTH];
    Error error;
    spread(sky, directions);
    if (!sky_probe_ask(probe, sky, directions, BOTH, radiances, &error)) fail_msg("%s", error.text);
}

static void assert_claim(SkyProbe *probe, const SkyState *sky, const float *wanted) {
    static float got[4 * BOTH];
    double sun = sky->sun.elevation_deg, claimed = bias_sky_percent(&probe->choice, sun, &sky->atmosphere),
           height = sky->atmosphere.observer_height_m;
    /* Nothing is claimed in the uppermost 3 km of the air, and something everywhere else. */
    assert_int_equal(isnan(claimed), height > 57e3 && height <= 60e3);
    if (isnan(claimed)) return;
    ask(probe, sky, got);
    double seen = error_percent(got, wanted);
    print_message("%-22s sun %4g, %7g m, ozone %g: claimed %.4f %%, seen %.4f %%\n", probe->choice.text, sun,
                  height, sky->atmosphere.ozone, claimed, seen);
    assert_true(seen <= claimed);
}

/* The next number of a sequence that is the same everywhere, below `count`. */
static int draw(uint32_t *seed, int count) {
    *seed = *seed * 1664525 + 1013904223;
    return (int)((*seed >> 8) % (uint32_t)count);
}

/* Against gauss:12, whose own error in an air without ozone is far below these. */
static void test_sample(void **state) {
    (void)state;
    enum { METHODS = 5, CELLS = 60 };
    static const char *const methods[METHODS] = {"gauss:4", "gauss:6", "gauss:7", "paper:16x4",
                                                 "table:gauss:8@32x96"};
    static float wanted[4 * BOTH];
    SkyState sky = {.atmosphere = atmosphere_preset(0)->atmosphere};
    SkyProbe best, probes[METHODS];
    Context context;
    uint32_t seed = 1;
    support_open(&context);
    open_probe(&best, &context, "gauss:12", &sky.atmosphere);
    for (int m = 0; m < METHODS; m++) open_probe(&probes[m], &context, methods[m], &sky.atmosphere);
    for (int k = 0; k < CELLS; k++) {
        sky.atmosphere.observer_height_m = k ? heights[draw(&seed, HEIGHTS)] : 59500;
        sky.sun = sun_at(k ? suns[draw(&seed, SUNS)] : 0, 0, 0.2666);
        ask(&best, &sky, wanted);
        for (int m = 0; m < METHODS; m++) assert_claim(&probes[m], &sky, wanted);
    }
    for (int m = 0; m < METHODS; m++) sky_probe_destroy(&probes[m]);
    sky_probe_destroy(&best);
    context_close(&context);
}

/* Ozone's edges are not smooth, so that truth is the adaptive quadrature. */
static void test_ozone(void **state) {
    (void)state;
    enum { METHODS = 4, CELLS = 3 };
    static const char *const methods[METHODS] = {"gauss:5", "gauss:8", "gauss:9", "gauss:12"};
    static const double places[CELLS][2] = {{59500, 0}, {60800, -10}, {3000, -10}};
    static float directions[4 * BOTH], wanted[4 * BOTH];
    SkyState sky = {.atmosphere = atmosphere_preset(2)->atmosphere};
    SkyProbe probes[METHODS];
    Context context;
    support_open(&context);
    for (int m = 0; m < METHODS; m++) open_probe(&probes[m], &context, methods[m], &sky.atmosphere);
    SkyTruth *truth = sky_truth_create(&sky.atmosphere, NULL);
    for (int k = 0; k < CELLS; k++) {
        sky.atmosphere.observer_height_m = places[k][0];
        sky.sun = sun_at(places[k][1], 0, 0.2666);
        spread(&sky, directions);
        for (int i = 0; i < BOTH; i++) {
            double view[3], radiance[3];
            for (int c = 0; c < 3; c++) view[c] = (double)directions[4 * i + c];
            sky_truth_ask(truth, sky.atmosphere.observer_height_m, view, sky.sun.direction, radiance);
            for (int c = 0; c < 3; c++) wanted[4 * i + c] = (float)radiance[c];
        }
        for (int m = 0; m < METHODS; m++) assert_claim(&probes[m], &sky, wanted);
    }
    sky_truth_destroy(truth);
    for (int m = 0; m < METHODS; m++) sky_probe_destroy(&probes[m]);
    context_close(&context);
}

/* An air is like a measured one only if it is as thick: a tenth of the planet's radius is ten times the air.
 */
static void test_thickness(void **state) {
    (void)state;
    Atmosphere air = atmosphere_preset(0)->atmosphere;
    MethodChoice choice;
    Error error;
    assert_true(method_choose(&choice, METHOD_SKY, "gauss:8", &error));
    air.top_radius_m = air.planet_radius_m + 63e3;
    assert_true(!isnan(bias_sky_percent(&choice, 30, &air)));
    air.top_radius_m = air.planet_radius_m + 80e3;
    assert_true(isnan(bias_sky_percent(&choice, 30, &air)));
    air.top_radius_m = air.planet_radius_m + 40e3;
    assert_true(isnan(bias_sky_percent(&choice, 30, &air)));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sample),
        cmocka_unit_test(test_ozone),
        cmocka_unit_test(test_thickness),
    };
    return cmocka_run_group_tests_name("bias_scan", tests, NULL, NULL);
}
