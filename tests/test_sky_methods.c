/* The sky's methods against ground truth: radiances by adaptive quadrature at 400 listed points (tests/data),
 * hemispherical irradiance, the limits, and the seams where a method changes its form. */
#include "support.h"

#include "sky/sky_probe.h"
#include "sky/sky_reference.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 4096 };

static const double degree = 3.14159265358979323846 / 180;

typedef struct Row {
    double height_m, sun_deg, view_deg, az_deg, radiance[3];
} Row;

static Row rows[MOST];
static int row_count;

static void read_rows(void) {
    char line[1024];
    FILE *file = fopen("tests/data/sky_single_scattering.csv", "r");
    if (!file) fail_msg("no tests/data/sky_single_scattering.csv");
    row_count = 0;
    while (fgets(line, sizeof line, file)) {
        Row *r = &rows[row_count];
        if (sscanf(line, "%lf,%lf,%lf,%lf,%lf,%lf,%lf", &r->height_m, &r->sun_deg, &r->view_deg, &r->az_deg,
                   &r->radiance[0], &r->radiance[1], &r->radiance[2]) == 7) {
            row_count++;
        }
    }
    fclose(file);
    assert_int_equal(row_count, 400);
}

static void unit_vector(double elevation_deg, double azimuth_deg, double out[3]) {
    out[0] = cos(elevation_deg * degree) * sin(azimuth_deg * degree);
    out[1] = sin(elevation_deg * degree);
    out[2] = cos(elevation_deg * degree) * cos(azimuth_deg * degree);
}

static void open_probe(const Context *context, SkyProbe *probe, const char *method,
                       const Atmosphere *atmosphere) {
    MethodChoice choice;
    Error error;
    if (!method_choose(&choice, METHOD_SKY, method, &error) ||
        !sky_probe_create(probe, context, support_sources(), &choice, atmosphere, &error)) {
        fail_msg("%s", error.text);
    }
}

/* One direction of a sky; slow, for few. */
static void ask(SkyProbe *probe, const Atmosphere *atmosphere, double height, double sun_deg, double view_deg,
                double az_deg, float out[4]) {
    SkyState state = {*atmosphere, sun_at(sun_deg, 0, 0.2666)};
    double view[3];
    Error error;
    state.atmosphere.observer_height_m = height;
    unit_vector(view_deg, az_deg, view);
    for (int c = 0; c < 3; c++) out[c] = (float)view[c];
    if (!sky_probe_ask(probe, &state, out, 1, out, &error)) fail_msg("%s", error.text);
}

typedef struct Figures {
    double rms, p99, max; /* percent */
} Figures;

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static Figures figures_of(double *errors, int count) {
    double squares = 0;
    qsort(errors, (size_t)count, sizeof *errors, ascending);
    for (int i = 0; i < count; i++) squares += errors[i] * errors[i];
    return (Figures){100 * sqrt(squares / count), 100 * errors[(int)ceil(0.99 * count) - 1],
                     100 * errors[count - 1]};
}

/* |L - Lref| / max(Lref, floor) of a method over the rows that are at a height and with the sun in a range.
 */
static Figures row_figures(const Context *context, const char *method, double height, double sun_low,
                           double sun_high, double floor_share) {
    static const double millionth[3] = {1.43e-6, 1.47e-6, 1.54e-6};
    static double errors[3 * MOST];
    const Atmosphere *atmosphere = &atmosphere_preset(0)->atmosphere;
    SkyProbe probe;
    double mean[3] = {0};
    int count = 0, used = 0;
    open_probe(context, &probe, method, atmosphere);
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < row_count; i++) {
            const Row *r = &rows[i];
            float got[4];
            if ((height >= 0 && r->height_m != height) || r->sun_deg < sun_low || r->sun_deg > sun_high)
                continue;
            if (pass == 0) {
                for (int c = 0; c < 3; c++) mean[c] += r->radiance[c];
                used++;
                continue;
            }
            ask(&probe, atmosphere, r->height_m, r->sun_deg, r->view_deg, r->az_deg, got);
            for (int c = 0; c < 3; c++) {
                double floor = floor_share > 0 ? floor_share * mean[c] / used : millionth[c];
                assert_true(isfinite(got[c]) && got[c] >= 0);
                errors[count++] = fabs((double)got[c] - r->radiance[c]) / fmax(r->radiance[c], floor);
            }
        }
    }
    sky_probe_destroy(&probe);
    Figures f = figures_of(errors, count);
    print_message("%-14s %3d rows: RMS %.4f %%, p99 %.3f %%, max %.3f %%\n", method, used, f.rms, f.p99,
                  f.max);
    return f;
}

static void test_rows(void **state) {
    (void)state;
    Context context;
    Figures f;
    support_open(&context);
    read_rows();
    f = row_figures(&context, "gauss:6", -1, -90, 90, 0);
    assert_true(f.rms <= 0.3 && f.max <= 5);
    f = row_figures(&context, "gauss:8", -1, -90, 90, 0);
    assert_true(f.rms <= 0.03 && f.p99 <= 0.1 && f.max <= 0.6);
    f = row_figures(&context, "gauss:12", -1, -90, 90, 0);
    assert_true(f.rms <= 0.001 && f.max <= 0.02);
    /* The paper's sums fail, as they must: 8 to 29 % by day, worse at low sun. */
    f = row_figures(&context, "paper:16x4", 1, 5, 90, 0);
    assert_true(f.rms > 5 && f.rms < 30);
    f = row_figures(&context, "paper:16x4", 1, -6, 2, 0);
    assert_true(f.rms > 10 && f.max > 40);
    f = row_figures(&context, "table", 1, 5, 90, 0);
    assert_true(f.rms <= 0.1);
    f = row_figures(&context, "table", 1, 0, 2, 0);
    assert_true(f.rms <= 0.3);
    f = row_figures(&context, "table", 1, -6, -2, 1e-3);
    assert_true(f.rms <= 0.7);
    context_close(&context);
}

/* The table against what fills it, in directions dense at the horizon. */
static void test_table(void **state) {
    (void)state;
    static const struct {
        double sun, bound;
    } cases[] = {{90, 0.1}, {60, 0.1}, {30, 0.1}, {10, 0.1}, {5, 0.1}, {2, 0.3},
                 {1, 0.3},  {0, 0.3},  {-2, 0.7}, {-4, 0.7}, {-6, 0.7}};
    static float table[4 * MOST], direct[4 * MOST];
    static double errors[3 * MOST];
    const Atmosphere *atmosphere = &atmosphere_preset(0)->atmosphere;
    Context context;
    SkyProbe probes[2];
    Error error;
    support_open(&context);
    open_probe(&context, &probes[0], "table:gauss:8", atmosphere);
    open_probe(&context, &probes[1], "gauss:8", atmosphere);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        SkyState sky = {*atmosphere, sun_at(cases[k].sun, 20, 0.2666)};
        double mean[3] = {0};
        for (int i = 0; i < MOST; i++) {
            double u = (i + 0.5) / MOST, view[3];
            double elevation = i % 2 ? 90 * u : pow(10, 4 * u - 2) * 0.9; /* even rows: 0.009 to 90 degrees */
            unit_vector(elevation, 137.5 * i, view);
            for (int c = 0; c < 3; c++) direct[4 * i + c] = (float)view[c];
        }
        if (!sky_probe_ask(&probes[0], &sky, direct, MOST, table, &error) ||
            !sky_probe_ask(&probes[1], &sky, direct, MOST, direct, &error)) {
            fail_msg("%s", error.text);
        }
        for (int i = 0; i < MOST; i++) {
            for (int c = 0; c < 3; c++) mean[c] += (double)direct[4 * i + c] / MOST;
        }
        for (int i = 0; i < 3 * MOST; i++) {
            double a = (double)table[4 * (i / 3) + i % 3], b = (double)direct[4 * (i / 3) + i % 3];
            errors[i] = fabs(a - b) / fmax(b, 1e-3 * mean[i % 3]);
        }
        Figures f = figures_of(errors, 3 * MOST);
        print_message("table, sun %5.1f: RMS %.4f %%, p99 %.3f %%, max %.3f %%\n", cases[k].sun, f.rms, f.p99,
                      f.max);
        assert_true(f.rms <= cases[k].bound);
    }
    sky_probe_destroy(&probes[0]);
    sky_probe_destroy(&probes[1]);
    context_close(&context);
}

/* Filled when the sun's height, the observer or the air changes, and only then. */
static void test_fills(void **state) {
    (void)state;
    Context context;
    SkyProbe probe;
    SkyState sky = {atmosphere_preset(0)->atmosphere, sun_at(30, 0, 0.2666)};
    float direction[4] = {0, 1, 0, 0}, radiance[4];
    Error error;
    support_open(&context);
    open_probe(&context, &probe, "table", &sky.atmosphere);
    static const int expected[] = {1, 1, 1, 2, 3, 4};
    for (int step = 0; step < 6; step++) {
        if (step == 2) sky.sun = sun_at(30, 90, 0.2666);
        if (step == 3) sky.sun = sun_at(1, 90, 0.2666);
        if (step == 4) sky.atmosphere.observer_height_m = 50;
        if (step == 5) sky.atmosphere.mie_scatter_per_m[1] = 1e-5;
        assert_true(sky_probe_ask(&probe, &sky, direction, 1, radiance, &error));
        assert_int_equal(resources_find(&probe.tables, &sky_table)->fills, expected[step]);
    }
    sky_probe_destroy(&probe);
    context_close(&context);
}

/* Cosine-weighted sky irradiance against data/irradiance.csv. */
static void test_irradiance(void **state) {
    (void)state;
    enum { SIDE = 512 };
    static const char *const methods[] = {"gauss:8", "table"};
    float *values = malloc(4 * SIDE * SIDE * sizeof *values);
    const Atmosphere *atmosphere = &atmosphere_preset(0)->atmosphere;
    Context context;
    Error error;
    char line[256];
    support_open(&context);
    for (int m = 0; m < 2; m++) {
        SkyProbe probe;
        double worst = 0, sun, expected[3];
        int suns = 0;
        open_probe(&context, &probe, methods[m], atmosphere);
        FILE *file = fopen("tests/data/irradiance.csv", "r");
        assert_non_null(file);
        while (fgets(line, sizeof line, file)) {
            double sum[3] = {0};
            if (sscanf(line, "%lf,%lf,%lf,%lf", &sun, &expected[0], &expected[1], &expected[2]) != 4)
                continue;
            suns++;
            for (int i = 0; i < SIDE * SIDE; i++) {
                double c = (i / SIDE + 0.5) / SIDE, view[3]; /* even in the sine: fine at the horizon */
                unit_vector(asin(c) / degree, 360.0 * (i % SIDE + 0.5) / SIDE, view);
                for (int k = 0; k < 3; k++) values[4 * i + k] = (float)view[k];
            }
            SkyState sky = {*atmosphere, sun_at(sun, 0, 0.2666)};
            assert_true(sky_probe_ask(&probe, &sky, values, (size_t)SIDE * SIDE, values, &error));
            for (int i = 0; i < 3 * SIDE * SIDE; i++) {
                sum[i % 3] += (double)values[4 * (i / 3) + i % 3] * 2 * (i / 3 / SIDE + 0.5) / SIDE;
            }
            for (int c = 0; c < 3; c++) {
                double percent = 100 * (sum[c] * acos(-1.0) / (SIDE * SIDE) / expected[c] - 1);
                worst = fmax(worst, fabs(percent));
                if (fabs(percent) > 0.2)
                    fail_msg("%s, sun %g, channel %d: %.3f %%", methods[m], sun, c, percent);
            }
        }
        fclose(file);
        assert_int_equal(suns, 11);
        print_message("irradiance by %s: worst of 11 suns %.3f %%\n", methods[m], worst);
        sky_probe_destroy(&probe);
    }
    free(values);
    context_close(&context);
}

/* Across each seam of the method the radiance moves by less than 1e-3: two directions, suns or heights a hair
 * apart. */
static void test_seams(void **state) {
    (void)state;
    static const struct {
        const char *what;
        double height[2], sun[2], view[2];
    } cases[] = {
        {"sun through the horizon", {1, 1}, {-0.0001, 0.0001}, {30, 30}},
        {"sun through the planet's shadow at the observer", {1000, 1000}, {-1.0160, -1.0158}, {40, 40}},
        {"terminator at the zenith", {1, 1}, {-4.0001, -3.9999}, {90, 90}},
        {"perigee at the observer", {10000, 10000}, {20, 20}, {-0.0001, 0.0001}},
        {"perigee at the observer, low sun", {10000, 10000}, {1, 1}, {-0.0001, 0.0001}},
        {"through the top of the atmosphere", {59999.9, 60000.1}, {20, 20}, {-10, -10}},
        {"through the top, twilight", {59999.9, 60000.1}, {-5, -5}, {-4, -4}},
        {"straight up", {1, 1}, {20, 20}, {89.999, 90}},
        {"toward the sun", {1, 1}, {20, 20}, {20.0001, 20}},
        {"erfcx at 8, where its fits used to change", {1, 1}, {23.63, 23.65}, {10, 10}},
    };
    static const char *const methods[] = {"gauss:8", "gauss:12"};
    const Atmosphere *atmosphere = &atmosphere_preset(0)->atmosphere;
    Context context;
    support_open(&context);
    for (int m = 0; m < 2; m++) {
        SkyProbe probe;
        open_probe(&context, &probe, methods[m], atmosphere);
        for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
            float a[4], b[4];
            ask(&probe, atmosphere, cases[i].height[0], cases[i].sun[0], cases[i].view[0], 30, a);
            ask(&probe, atmosphere, cases[i].height[1], cases[i].sun[1], cases[i].view[1], 30, b);
            for (int c = 0; c < 3; c++) {
                double jump = fabs((double)a[c] - (double)b[c]) / fmax((double)b[c], 1e-9);
                if (jump > 1e-3)
                    fail_msg("%s, %s: channel %d jumps by %.2e", methods[m], cases[i].what, c, jump);
            }
        }
        sky_probe_destroy(&probe);
    }
    context_close(&context);
}

/* The horizon's own step, dark ground below a bright sky, is the reference's. */
static void test_horizon(void **state) {
    (void)state;
    static const double heights[] = {0, 0.1, 0.3, 1, 10, 1000};
    const Atmosphere *atmosphere = &atmosphere_preset(0)->atmosphere;
    Context context;
    SkyProbe probe;
    support_open(&context);
    open_probe(&context, &probe, "gauss:8", atmosphere);
    for (int i = 0; i < 6; i++) {
        double h = heights[i], r = atmosphere->planet_radius_m, dip = acos(r / (r + h)) / degree;
        for (int side = -1; side <= 1; side++) {
            double view[3], sun[3], expected[3], elevation = -dip + side * 0.003;
            float got[4];
            if (side == 0 && h > 0)
                continue; /* on the edge itself either answer is right, but at height 0 the sky's is */
            unit_vector(elevation, 30, view);
            unit_vector(10, 0, sun);
            sky_reference(atmosphere, h, view, sun, expected);
            ask(&probe, atmosphere, h, 10, elevation, 30, got);
            for (int c = 0; c < 3; c++) {
                if (fabs((double)got[c] - expected[c]) > 2e-3 * expected[c] + 1e-9) {
                    fail_msg("height %g, %g degrees: %g, reference %g", h, elevation, (double)got[c],
                             expected[c]);
                }
            }
        }
    }
    sky_probe_destroy(&probe);
    context_close(&context);
}

/* Whatever the settings admit gives finite radiance, never below 0; no ray is lost at the ground or along the
 * horizon. */
static void test_extremes(void **state) {
    (void)state;
    static const char *const methods[] = {"gauss:4", "gauss:8", "gauss:12", "table:gauss:8@32x96",
                                          "paper:16x4"};
    static const double densities[] = {0, 1, 100, 10000}, asymmetries[] = {-0.999, 0, 0.76, 0.999};
    static const double heights[] = {0, 0.1, 0.3, 1, 10, 59999, 60000, 60001, 1e6};
    static const double suns[] = {90, 20, 0, -2, -18, -90};
    static const double views[] = {90, 30, 0.01, 0, -0.01, -0.5, -30, -90};
    Context context;
    Error error;
    support_open(&context);
    for (int m = 0; m < 5; m++) {
        for (int ozone = 0; ozone < 2; ozone++) {
            Atmosphere atmosphere = atmosphere_preset(0)->atmosphere;
            SkyProbe probe;
            atmosphere.ozone = ozone;
            open_probe(&context, &probe, methods[m], &atmosphere);
            for (int k = 0; k < 4 * 4 * 9 * 6; k++) {
                float values[4 * 8 * 3];
                SkyState sky = {atmosphere, sun_at(suns[k % 6], 0, 0.2666)};
                sky.atmosphere.observer_height_m = heights[k / 6 % 9];
                sky.atmosphere.rayleigh = sky.atmosphere.mie = densities[k / 54 % 4];
                sky.atmosphere.mie_g = asymmetries[k / 216];
                for (int i = 0; i < 24; i++) {
                    double view[3];
                    unit_vector(views[i % 8], 90.0 * (i / 8), view);
                    for (int c = 0; c < 3; c++) values[4 * i + c] = (float)view[c];
                }
                assert_true(sky_probe_ask(&probe, &sky, values, 24, values, &error));
                for (int i = 0; i < 24; i++) {
                    for (int c = 0; c < 3; c++) {
                        float got = values[4 * i + c];
                        if (!isfinite(got) || got < 0) {
                            fail_msg("%s, height %g, sun %g, view %g, density x%g, g %g: %g", methods[m],
                                     sky.atmosphere.observer_height_m, sky.sun.elevation_deg, views[i % 8],
                                     sky.atmosphere.mie, sky.atmosphere.mie_g, (double)got);
                        }
                    }
                    bool sky_seen = views[i % 8] >= 0 && sky.sun.elevation_deg >= 20 &&
                                    sky.atmosphere.mie == 1 && sky.atmosphere.observer_height_m <= 10;
                    if (sky_seen && !(values[4 * i + 1] > 1e-3f)) fail_msg("%s: a ray is lost", methods[m]);
                }
            }
            sky_probe_destroy(&probe);
        }
    }
    context_close(&context);
}

/* `earth`, with ozone, against the adaptive quadrature, which integrates the tent itself. */
static void test_earth(void **state) {
    (void)state;
    static const double suns[] = {60, 10, 2, 0, -2, -4, -6};
    static const double heights[] = {1, 1, 1, 10000, 100000};
    static double errors[3 * 7 * 5 * 8];
    Atmosphere atmosphere;
    Context context;
    SkyProbe probe;
    Error error;
    int count = 0;
    support_open(&context);
    assert_true(atmosphere_choose(&atmosphere, "simmons2017-ozone", &error));
    open_probe(&context, &probe, "gauss:8", &atmosphere);
    for (int i = 0; i < 7 * 5 * 8; i++) {
        double view[3], sun[3], expected[3], height = heights[i % 5],
                                             elevation = i % 8 ? 90 * pow((i % 8) / 7.0, 3) : 0.05;
        float got[4];
        if (height > 1) elevation -= acos(6360e3 / (6360e3 + height)) / degree;
        unit_vector(elevation, 25.0 * (i % 7), view);
        unit_vector(suns[i / 40], 0, sun);
        sky_reference(&atmosphere, height, view, sun, expected);
        ask(&probe, &atmosphere, height, suns[i / 40], elevation, 25.0 * (i % 7), got);
        for (int c = 0; c < 3; c++)
            errors[count++] = fabs((double)got[c] - expected[c]) / fmax(expected[c], 1.5e-6);
    }
    sky_probe_destroy(&probe);
    Figures f = figures_of(errors, count);
    print_message("earth by gauss:8: RMS %.4f %%, p99 %.3f %%, max %.3f %%\n", f.rms, f.p99, f.max);
    assert_true(f.rms < 0.25); /* the tent's kinks, which no node knows of */
    context_close(&context);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rows),  cmocka_unit_test(test_table),    cmocka_unit_test(test_fills),
        cmocka_unit_test(test_seams), cmocka_unit_test(test_horizon),  cmocka_unit_test(test_irradiance),
        cmocka_unit_test(test_earth), cmocka_unit_test(test_extremes),
    };
    return cmocka_run_group_tests_name("sky methods", tests, support_folder, support_clean);
}
