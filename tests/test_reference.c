/* The CPU's sky: against radiances and irradiances by other programs, against cases with a closed form, and
 * at the ends of what may be set. */
#include "support.h"

#include "sky/sky_reference.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ELEVATIONS = 24, AZIMUTHS = 16 };

static const double degree = 3.14159265358979323846 / 180;

static Atmosphere preset(const char *name) {
    Atmosphere atmosphere;
    Error error;
    if (!atmosphere_choose(&atmosphere, name, &error)) fail_msg("%s", error.text);
    return atmosphere;
}

/* Straight up, down and along stay exact. */
static void direction(double elevation_deg, double azimuth_deg, double out[3]) {
    double flat = fabs(elevation_deg) == 90 ? 0 : cos(elevation_deg * degree);
    out[0] = flat * sin(azimuth_deg * degree);
    out[1] = sin(elevation_deg * degree);
    out[2] = flat * cos(azimuth_deg * degree);
}

/* View and sun as elevations; the azimuth is between them. */
static void radiance(const Atmosphere *atmosphere, double height_m, double view_deg, double azimuth_deg,
                     double sun_deg, double out[3]) {
    double view[3], sun[3];
    direction(view_deg, azimuth_deg, view);
    direction(sun_deg, 0, sun);
    sky_reference(atmosphere, height_m, view, sun, out);
}

static void transmittance(const Atmosphere *atmosphere, double height_m, double elevation_deg,
                          double out[3]) {
    double unit[3];
    direction(elevation_deg, 0, unit);
    sky_reference_transmittance(atmosphere, height_m, unit, out);
}

static void expect_near(const char *what, double got, double expected, double tolerance) {
    if (!(fabs(got - expected) <= tolerance * fabs(expected) + 1e-24))
        fail_msg("%s: %.17g, expected %.17g", what, got, expected);
}

/* Relative; 0 where both are too faint for their digits to count. */
static double worst_error(const double got[3], const double expected[3]) {
    double worst = 0;
    for (int c = 0; c < 3; c++) {
        if (fmax(got[c], expected[c]) > 1e-12) worst = fmax(worst, fabs(got[c] - expected[c]) / expected[c]);
    }
    return worst;
}

/* The next row of numbers, `count` of them at the line's start; false at the end. */
static bool next_row(FILE *file, int count, double *row) {
    char line[2048];
    while (fgets(line, sizeof line, file)) {
        int at = 0, i = 0, size = 0;
        for (; i < count && sscanf(line + at, "%lf%n", &row[i], &size) == 1; i++) at += size + 1;
        if (i == count) return true;
    }
    return false;
}

/* The file is good to 1e-8 by its own words. Its worst row, the zenith with the sun at the horizon, has a
 * square root's singularity at the top of the atmosphere; there an 18-digit quadrature sides with ours to
 * 2e-13.
 *
 * The parts: scattering times a number, with the extinction ratio divided by it, leaves the extinction as it
 * is, and makes the Mie part vanish beside the Rayleigh part or the other way round. */
static void test_radiances(void **state) {
    (void)state;
    const double faint = 1e-24, bright = 1e24;
    Atmosphere whole = preset("simmons2017"), rayleigh = whole, mie = whole;
    for (int c = 0; c < 3; c++) rayleigh.mie_scatter_per_m[c] *= faint, mie.mie_scatter_per_m[c] *= bright;
    rayleigh.mie_extinction_ratio /= faint;
    mie.mie_extinction_ratio /= bright;
    const Atmosphere *atmospheres[3] = {&whole, &rayleigh, &mie};
    double row[13], got[3], worst[3] = {0};
    int rows = 0, close[3] = {0};
    FILE *file = fopen("tests/data/sky_single_scattering.csv", "r");
    assert_non_null(file);
    for (; next_row(file, 13, row); rows++) {
        for (int part = 0; part < 3; part++) {
            radiance(atmospheres[part], row[0], row[2], row[3], row[1], got);
            for (int c = 0; c < 3; c++) got[c] /= part == 2 ? bright : 1;
            double error = worst_error(got, row + 4 + 3 * part);
            if (error > 1e-10)
                print_message("%g m, sun %g, view %g %g: %.2e\n", row[0], row[1], row[2], row[3], error);
            worst[part] = fmax(worst[part], error);
            close[part] += error < 1e-10;
        }
    }
    fclose(file);
    static const char *names[] = {"radiance", "Rayleigh part", "Mie part"};
    assert_int_equal(rows, 400);
    for (int part = 0; part < 3; part++) {
        print_message("%s: largest error %.2e, %d of %d below 1e-10\n", names[part], worst[part], close[part],
                      rows);
        assert_true(worst[part] < 1e-8 && close[part] >= 399);
    }
}

/* Gauss-Legendre on (0, 1), by Newton's method on the polynomial. */
static void gauss_legendre(int count, double *node, double *weight) {
    for (int i = 0; i < count; i++) {
        double z = cos(180 * degree * (i + 0.75) / (count + 0.5)), slope = 1;
        for (int step = 0; step < 10; step++) {
            double p = 1, before = 0;
            for (int k = 1; k <= count; k++) {
                double next = ((2 * k - 1) * z * p - (k - 1) * before) / k;
                before = p, p = next;
            }
            slope = count * (z * p - before) / (z * z - 1);
            z -= p / slope;
        }
        node[i] = (1 - z) / 2;
        weight[i] = 1 / ((1 - z * z) * slope * slope);
    }
}

/* On the ground at 1 m. Both angles go with a square: nodes crowd at the horizon and at the sun's azimuth. */
static void irradiance(const Atmosphere *atmosphere, double sun_deg, double out[3]) {
    double u[ELEVATIONS], wu[ELEVATIONS], v[AZIMUTHS], wv[AZIMUTHS];
    gauss_legendre(ELEVATIONS, u, wu);
    gauss_legendre(AZIMUTHS, v, wv);
    memset(out, 0, 3 * sizeof *out);
    for (int i = 0; i < ELEVATIONS; i++) {
        for (int k = 0; k < AZIMUTHS; k++) {
            double elevation = 90 * u[i] * u[i], azimuth = 180 * v[k] * v[k], got[3];
            double solid =
                wu[i] * 180 * degree * u[i] * cos(elevation * degree) * wv[k] * 720 * degree * v[k];
            radiance(atmosphere, 1, elevation, azimuth, sun_deg, got);
            for (int c = 0; c < 3; c++) out[c] += solid * sin(elevation * degree) * got[c];
        }
    }
}

static void test_irradiances(void **state) {
    (void)state;
    Atmosphere atmosphere = preset("simmons2017");
    double row[7], got[3], worst = 0, worst_sun = 0;
    int rows = 0;
    FILE *file = fopen("tests/data/irradiance.csv", "r");
    assert_non_null(file);
    for (; next_row(file, 7, row); rows++) {
        irradiance(&atmosphere, row[0], got);
        worst = fmax(worst, worst_error(got, row + 1));
        transmittance(&atmosphere, 1, row[0], got);
        for (int c = 0; c < 3; c++) got[c] *= atmosphere.sun_irradiance[c];
        worst_sun = fmax(worst_sun, worst_error(got, row + 4));
    }
    fclose(file);
    print_message("%d irradiances: largest error of the sky's %.2e, of the sun's %.2e\n", rows, worst,
                  worst_sun);
    assert_int_equal(rows, 11);
    assert_true(worst < 2e-5 && worst_sun < 1e-8);
}

/* Toward the sun, light loses the same on any way: 20 p depth exp(-depth). Away from it, down from space, it
 * goes the way twice: 20 p (1 - exp(-2 depth)) / 2. */
static void test_closed_forms(void **state) {
    (void)state;
    static const double elevations[] = {90, 45, 3, 0, -1.5}, heights[] = {0, 1, 3000, 59000, 4e5};
    static const double densities[] = {1e-6, 1, 30, 1e4};
    double got[3], through[3], phase = 3 / (8 * 180 * degree);
    for (int i = 0; i < 5 * 5 * 4; i++) {
        double elevation = elevations[i % 5], height = heights[i / 5 % 5];
        Atmosphere air = preset("simmons2017");
        air.mie = 0;
        air.rayleigh = densities[i / 25];
        radiance(&air, height, elevation, 0, elevation, got);
        transmittance(&air, height, elevation, through);
        for (int c = 0; c < 3; c++) {
            /* With thin air the logarithm has lost its digits. */
            if (through[c] == 0 || through[c] > 0.999) continue;
            expect_near("toward the sun", got[c], 20 * phase * -log(through[c]) * through[c], 1e-10);
        }
        radiance(&air, 4e5, -90, 0, 90, got);
        for (int c = 0; c < 3; c++) {
            double scale = air.rayleigh_scale_height_m;
            double depth = air.rayleigh * air.rayleigh_scatter_per_m[c] * scale * -expm1(-60e3 / scale);
            expect_near("down from space", got[c], -10 * phase * expm1(-2 * depth), 1e-10);
        }
    }
}

/* Next to no extinction: the columns of both gases, times their phase functions. */
static void test_thin(void **state) {
    (void)state;
    static const double suns[] = {90, 40, 5};
    Atmosphere thin = preset("simmons2017");
    thin.rayleigh = thin.mie = 1e-6;
    for (int i = 0; i < 3; i++) {
        double got[3], nu = sin(suns[i] * degree), g = thin.mie_g, pi = 180 * degree;
        double rayleigh = 3 / (16 * pi) * (1 + nu * nu);
        double mie =
            3 / (8 * pi) * (1 - g * g) * (1 + nu * nu) / ((2 + g * g) * pow(1 + g * g - 2 * g * nu, 1.5));
        radiance(&thin, 0, 90, 0, suns[i], got);
        for (int c = 0; c < 3; c++) {
            double expected =
                20e-6 * (rayleigh * thin.rayleigh_scatter_per_m[c] * 7994 * -expm1(-60 / 7.994) +
                         mie * thin.mie_scatter_per_m[c] * 1200 * -expm1(-60 / 1.2));
            expect_near("thin", got[c], expected, 5e-6);
        }
    }
}

static void test_symmetry(void **state) {
    (void)state;
    Atmosphere earth = preset("simmons2017-ozone");
    double got[3], mirrored[3], view[3], sun[3], half[3], limb[3];
    for (int i = 0; i < 24; i++) {
        double azimuth = 15 * i + 1, elevation = i * 7 % 40 - 5, turn = 77 * i;
        radiance(&earth, 5000, elevation, azimuth, 4, got);
        radiance(&earth, 5000, elevation, -azimuth, 4, mirrored);
        assert_true(worst_error(got, mirrored) < 1e-13);
        direction(elevation, azimuth + turn, view);
        direction(4, turn, sun);
        sky_reference(&earth, 5000, view, sun, mirrored);
        assert_true(worst_error(got, mirrored) < 1e-9);
    }
    /* A ray that grazes the air from space is twice the one from its perigee. */
    for (double height = 0; height < 60e3; height += 7e3) {
        double cosine = (earth.planet_radius_m + height + 1e-3) / (earth.planet_radius_m + 4e5);
        transmittance(&earth, height + 1e-3, 0, half);
        sky_reference_transmittance(&earth, 4e5, (double[3]){0, -sqrt(1 - cosine * cosine), cosine}, limb);
        for (int c = 0; c < 3; c++) half[c] *= half[c];
        assert_true(worst_error(limb, half) < 1e-9);
    }
}

/* The planet's shadow reaches the zenith's last air at 7.84 degrees, and the horizon's at twice that. */
static void test_shadow(void **state) {
    (void)state;
    Atmosphere atmosphere = preset("simmons2017");
    double edge = acos(atmosphere.planet_radius_m / atmosphere.top_radius_m) / degree, got[3];
    assert_true(fabs(edge - 7.84) < 0.005);
    radiance(&atmosphere, 0, 90, 0, -edge + 1e-3, got);
    assert_true(got[0] > 0 && got[2] > 0);
    radiance(&atmosphere, 0, 90, 0, -edge - 1e-3, got);
    assert_true(got[0] == 0 && got[1] == 0 && got[2] == 0);
    radiance(&atmosphere, 0, 0, 0, -2 * edge + 1e-3, got);
    assert_true(got[0] > 0);
    for (int i = 0; i <= 90; i++) {
        for (int k = 0; k <= 12; k++) {
            radiance(&atmosphere, 0, i, 15 * k, -2 * edge - 1e-3, got);
            assert_true(got[0] == 0 && got[1] == 0 && got[2] == 0);
        }
    }
    /* Never lit from below. */
    transmittance(&atmosphere, 1, -1, got);
    assert_true(got[0] == 0 && got[1] == 0 && got[2] == 0);
}

static void test_extremes(void **state) {
    (void)state;
    static const double densities[] = {0, 1, 100, 1e4, 1e6}, gs[] = {-0.999, 0.76, 0.999};
    static const double heights[] = {0, 0.1, 59999, 60000, 60001, 1e6};
    static const double views[] = {90, 45, 1e-9, 0, -1e-9, -10, -90}, suns[] = {90, 1e-9, 0, -3, -90};
    Atmosphere atmosphere = preset("simmons2017-ozone");
    double got[3];
    int count = 0;
    for (int i = 0; i < 5 * 3 * 6 * 7 * 5; i++) {
        double height = heights[i / 15 % 6], view = views[i / 90 % 7], sun = suns[i / 630];
        atmosphere.rayleigh = atmosphere.mie = atmosphere.ozone = densities[i % 5];
        atmosphere.mie_g = gs[i / 5 % 3];
        for (int k = 0; k < 2; k++) {
            radiance(&atmosphere, height, view, 180 * k, sun, got);
            for (int c = 0; c < 3; c++, count++) {
                if (!(isfinite(got[c]) && got[c] >= 0))
                    fail_msg("%g m, view %g, sun %g: %g", height, view, sun, got[c]);
                if (atmosphere.rayleigh == 0) assert_true(got[c] == 0);
            }
        }
        transmittance(&atmosphere, height, view, got);
        for (int c = 0; c < 3; c++) assert_true(got[c] >= 0 && got[c] <= 1);
    }
    print_message("%d values\n", count);
}

/* What ozone changes of the sky's irradiance, in percent, as found by another program; rounded as printed. */
static void test_ozone(void **state) {
    (void)state;
    static const struct {
        double sun, change[3], rounding[3];
    } rows[] = {{60, {-1.1, -3.3, -0.2}, {0.05, 0.05, 0.05}},
                {10, {-4.9, -13, -0.6}, {0.05, 0.5, 0.05}},
                {2, {-11, -29, -1.6}, {0.5, 0.5, 0.05}},
                {-4, {-25, -58, -4}, {0.5, 0.5, 0.5}}};
    Atmosphere without = preset("simmons2017"), with = preset("simmons2017-ozone");
    for (int i = 0; i < 4; i++) {
        double before[3], after[3];
        irradiance(&without, rows[i].sun, before);
        irradiance(&with, rows[i].sun, after);
        for (int c = 0; c < 3; c++) {
            double change = 100 * (after[c] / before[c] - 1);
            print_message("sun %g, channel %d: %.3f %%\n", rows[i].sun, c, change);
            assert_true(fabs(change - rows[i].change[c]) <= rows[i].rounding[c] + 0.005);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_radiances),    cmocka_unit_test(test_irradiances),
        cmocka_unit_test(test_closed_forms), cmocka_unit_test(test_thin),
        cmocka_unit_test(test_symmetry),     cmocka_unit_test(test_shadow),
        cmocka_unit_test(test_extremes),     cmocka_unit_test(test_ozone),
    };
    return cmocka_run_group_tests_name("reference", tests, NULL, NULL);
}
