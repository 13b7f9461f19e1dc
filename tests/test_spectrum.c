/* Colours from several wavelengths: the laws by which an air's settings become those of any wavelength, the
 * matrices, and colours of the sky and of the sun against 48 wavelengths. */
#include "colors.h"
#include "support.h"

#include "scene/spectrum.h"
#include "scene/spectrum_data.h"
#include "sky/sky_probe.h"
#include "sky/sky_reference.h"
#include "sky/sky_truth.h"
#include "sky/sun_disk.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { GREEN = 1 };

static const double pi = 3.14159265358979323846, degree = 3.14159265358979323846 / 180;

static Atmosphere air_of(const char *preset, double spectrum) {
    Atmosphere atmosphere;
    Error error;
    assert_true(atmosphere_choose(&atmosphere, preset, &error));
    atmosphere.spectrum = spectrum;
    return atmosphere;
}

static void unit_vector(double elevation_deg, double azimuth_deg, double out[3]) {
    out[0] = cos(elevation_deg * degree) * sin(azimuth_deg * degree);
    out[1] = sin(elevation_deg * degree);
    out[2] = cos(elevation_deg * degree) * cos(azimuth_deg * degree);
}

/* Pairs of Sharma, Wu and Dalal 2005, and the sun above the air. */
static void test_colors(void **state) {
    (void)state;
    static const double pairs[][7] = {
        {50, 2.6772, -79.7751, 50, 0, -82.7485, 2.0425},
        {50, 3.1571, -77.2803, 50, 0, -82.7485, 2.8615},
        {50, 0, 0, 50, -1, 2, 2.3669},
        {50, 2.4900, -0.0010, 50, -2.4900, 0.0009, 7.1792},
        {50, 2.4900, -0.0010, 50, -2.4900, 0.0011, 7.2195},
        {50, -0.0010, 2.4900, 50, 0.0011, -2.4900, 4.7461},
        {50, 2.5, 0, 50, 0, -2.5, 4.3065},
        {50, 2.5, 0, 73, 25, -18, 27.1492},
        {60.2574, -34.0099, 36.2677, 60.4626, -34.1751, 39.4387, 1.2644},
        {22.7233, 20.0904, -46.6940, 23.0331, 14.9730, -42.5619, 2.0373},
        {90.9257, -0.5406, -0.9208, 88.6381, -0.8985, -0.7239, 1.5381},
        {6.7747, -0.2908, -2.4247, 5.8714, -0.0985, -2.2286, 0.6377},
        {2.0776, 0.0795, -1.1350, 0.9033, -0.0636, -0.5514, 0.9082},
    };
    double sun[COLORS_SAMPLES], rgb[3], lab[3];
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        const double *p = pairs[i];
        assert_true(fabs(colors_difference(p, p + 3) - p[6]) < 6e-5);
        assert_true(fabs(colors_difference(p + 3, p) - p[6]) < 6e-5);
    }
    for (int i = 0; i < COLORS_SAMPLES; i++) {
        sun[i] = 1;
        assert_true(colors_sun_per_nm(i) == spectrum_sun_per_nm(colors_wavelength_nm(i)));
    }
    colors_of_shares(sun, rgb);
    for (int c = 0; c < 3; c++) assert_true(fabs(rgb[c] - 1) < 1e-12);
    colors_lab(rgb, lab);
    assert_true(fabs(lab[0] - 100) < 1e-9 && fabs(lab[1]) < 1e-9 && fabs(lab[2]) < 1e-9);
}

static void test_matrices(void **state) {
    (void)state;
    static const double spectra[] = {3, 6};
    Atmosphere rgb = air_of("simmons2017-ozone", SPECTRUM_RGB);
    double matrix[3][3], nm[MOST_WAVELENGTHS];
    for (int s = 0; s < 2; s++) {
        Atmosphere air = air_of("simmons2017-ozone", spectra[s]);
        double sums[3] = {0};
        air.sun_irradiance[0] = 7;
        for (int band = 0; band < spectrum_bands(&air); band++) {
            spectrum_matrix(&air, band, matrix);
            for (int i = 0; i < 9; i++) sums[i / 3] += matrix[i / 3][i % 3];
        }
        /* White is the sun above the air. */
        for (int c = 0; c < 3; c++) assert_true(fabs(sums[c] - air.sun_irradiance[c]) < 1e-12);
        assert_int_equal(spectrum_wavelengths(&air, nm), (int)spectra[s]);
        assert_int_equal(spectrum_bands(&air), (int)spectra[s] / 3);
        for (int i = 1; i < spectra[s]; i++) assert_true(nm[i] < nm[i - 1]);
    }
    /* Without a spectrum nothing changes. */
    Atmosphere band = spectrum_band(&rgb, 0);
    assert_int_equal(spectrum_bands(&rgb), 1);
    assert_int_equal(spectrum_wavelengths(&rgb, nm), 0);
    assert_memory_equal(&band, &rgb, sizeof rgb);
    spectrum_matrix(&rgb, 0, matrix);
    for (int i = 0; i < 9; i++) assert_true(matrix[i / 3][i % 3] == (i / 3 == i % 3));
}

static void test_laws(void **state) {
    (void)state;
    Atmosphere earth = air_of("simmons2017-ozone", 6);
    Error error;
    assert_true(spectrum_check(&earth, &error));
    earth.mie_angstrom = 1.3;
    earth.ground_albedo[0] = 0.2;
    earth.ground_albedo[1] = 0.4;
    earth.ground_albedo[2] = 0.1;
    /* At the settings' green wavelength the amounts are the settings'. */
    Atmosphere air = spectrum_air_at(&earth, (const double[]){550, 275 * 2, 495});
    assert_true(air.rayleigh_scatter_per_m[0] == earth.rayleigh_scatter_per_m[GREEN]);
    assert_true(air.mie_scatter_per_m[1] == earth.mie_scatter_per_m[GREEN]);
    assert_true(air.spectrum == SPECTRUM_RGB && air.sun_irradiance[2] == 1 && air.wavelengths_nm[2] == 495);
    assert_true(fabs(air.mie_scatter_per_m[2] / air.mie_scatter_per_m[0] - pow(0.9, -1.3)) < 1e-12);
    /* A little more than the fourth power, because the air's refractive index rises toward the blue. */
    double exponent = log(air.rayleigh_scatter_per_m[2] / air.rayleigh_scatter_per_m[0]) / log(1 / 0.9);
    assert_true(exponent > 4.03 && exponent < 4.10);
    /* 300 Dobson units: the preset's absorption, as it was published for the three wavelengths. */
    air = spectrum_air_at(&earth, earth.wavelengths_nm);
    for (int c = 0; c < 3; c++) {
        assert_true(fabs(air.ozone_absorb_per_m[c] / earth.ozone_absorb_per_m[c] - 1) < 1e-3);
        assert_true(air.ground_albedo[c] == earth.ground_albedo[c]);
        assert_true(fabs(air.rayleigh_scatter_per_m[c] / earth.rayleigh_scatter_per_m[c] - 1) < 0.02);
    }
    /* The ground is linear between the wavelengths of the settings, and constant beyond. */
    air = spectrum_air_at(&earth, (const double[]){800, 615, 495});
    assert_true(air.ground_albedo[0] == 0.2 && fabs(air.ground_albedo[1] - 0.3) < 1e-12);
    assert_true(fabs(air.ground_albedo[2] - 0.25) < 1e-12);
    air = spectrum_air_at(&earth, (const double[]){440, 400, 360});
    assert_true(air.ground_albedo[1] == 0.1 && air.ground_albedo[2] == 0.1);
    /* Between the measured values, and at both ends. */
    assert_true(fabs(spectrum_sun_per_nm(365) - (1.11776 + 1.14259) / 2) < 1e-9);
    assert_true(fabs(spectrum_sun_per_nm(830) - 1.04992) < 1e-9);
}

/* Settings whose channels contradict the laws are refused, with what to do. */
static void test_refused(void **state) {
    (void)state;
    static const struct {
        const char *settings, *words;
    } cases[] = {
        {"--atmosphere simmons2017-author", "atmosphere.rayleigh_scatter_per_m"},
        {"--set atmosphere.rayleigh_scatter_per_m=1e-5", "atmosphere.rayleigh_scatter_per_m"},
        {"--set atmosphere.mie_angstrom=1", "atmosphere.mie_scatter_per_m within 5 % of"},
        {"--set atmosphere.mie_scatter_per_m=2e-5,2e-5,3e-5",
         "atmosphere.mie_scatter_per_m within 5 % of 2e-05"},
        {"--set atmosphere.ozone_absorb_per_m=1e-6 --set atmosphere.ozone=1",
         "atmosphere.ozone_absorb_per_m"},
        {"--set atmosphere.wavelengths_nm=440,550,680", "atmosphere.wavelengths_nm that fall"},
    };
    const char *csv = support_write("one.csv", "1,30,20,40\n");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        support_expect(2, "", "sky --at '%s' %s --set atmosphere.spectrum=6", csv, cases[i].settings);
        assert_non_null(strstr(support_err, cases[i].words));
        assert_non_null(strstr(support_err, "use atmosphere.spectrum=rgb"));
        support_expect(0, "", "sky --at '%s' %s --sky reference", csv, cases[i].settings);
    }
    support_expect(
        0, "",
        "sky --at '%s' --sky reference --set atmosphere.spectrum=3 "
        "--set atmosphere.mie_angstrom=1 --set atmosphere.mie_scatter_per_m=1.7e-5,2.1e-5,2.625e-5",
        csv);
    /* What is left out contradicts nothing. */
    support_expect(
        0, "",
        "sky --at '%s' --sky reference --set atmosphere.spectrum=3 "
        "--set atmosphere.ozone_absorb_per_m=1e-6 --set atmosphere.mie=0 --set atmosphere.mie_angstrom=1",
        csv);
}

/* The radiance of the sun's disk by 48 wavelengths, in the sun's own radiance. */
static void disk_by_many(const Atmosphere *atmosphere, const double direction[3], double rgb[3]) {
    double shares[COLORS_SAMPLES];
    for (int i = 0; i < COLORS_SAMPLES; i += 3) {
        double nm[3];
        for (int c = 0; c < 3; c++) nm[c] = colors_wavelength_nm(i + c);
        Atmosphere air = spectrum_air_at(atmosphere, nm);
        sky_reference_transmittance(&air, air.observer_height_m, direction, shares + i);
    }
    colors_of_shares(shares, rgb);
}

static void sky_by_many(const Atmosphere *atmosphere, double height, const double view[3],
                        const double sun[3], double rgb[3]) {
    double shares[COLORS_SAMPLES];
    for (int i = 0; i < COLORS_SAMPLES; i += 3) {
        double nm[3];
        for (int c = 0; c < 3; c++) nm[c] = colors_wavelength_nm(i + c);
        Atmosphere air = spectrum_air_at(atmosphere, nm);
        sky_reference(&air, height, view, sun, shares + i);
    }
    colors_of_shares(shares, rgb);
}

static void test_disk(void **state) {
    (void)state;
    static const double suns[] = {90, 40, 15, 6, 2, 0.6, 0.1}, irradiance[3] = {20, 10, 5};
    static const double spectra[] = {3, 6}, most[] = {3, 0.25}, most_luminance[] = {0.03, 0.003};
    double level = 1 / (pi * pow(sin(0.2666 * degree), 2));
    for (int s = 0; s < 2; s++) {
        Atmosphere air = air_of("simmons2017-ozone", spectra[s]);
        /* Above the air the sun has the colour of sun_irradiance. */
        Sun sun = sun_at(30, 0, 0.2666);
        double radiance[3], many[3];
        air.observer_height_m = 1e6;
        memcpy(air.sun_irradiance, irradiance, sizeof irradiance);
        SunDisk disk = sun_disk(&air, &sun);
        sun_disk_radiance(&disk, &air, sun.direction, radiance);
        for (int c = 0; c < 3; c++) assert_true(fabs(radiance[c] / (irradiance[c] * level) - 1) < 1e-9);
        for (int c = 0; c < 3; c++) air.sun_irradiance[c] = 1 / level;
        air.observer_height_m = 1;
        double redness = 0;
        for (int k = 0; k < 7; k++) {
            sun = sun_at(suns[k], 0, 0.2666);
            disk = sun_disk(&air, &sun);
            sun_disk_radiance(&disk, &air, sun.direction, radiance);
            disk_by_many(&air, sun.direction, many);
            double difference = colors_difference_of_hues(radiance, many);
            double off = fabs(colors_luminance(radiance) / colors_luminance(many) - 1);
            print_message("%g wavelengths, sun %g: %.4f %.4f %.4f, dE %.3f, luminance off by %.3f %%\n",
                          spectra[s], suns[k], radiance[0], radiance[1], radiance[2], difference, 100 * off);
            assert_true(difference < most[s] && off < most_luminance[s]);
            assert_true(radiance[0] / radiance[1] > redness);
            redness = radiance[0] / radiance[1];
        }
    }
}

/* Colours of the sky against 48 wavelengths, at rows that no fit has seen. */
static void test_against_many(void **state) {
    (void)state;
    static const double heights[] = {1, 2500, 12000}, suns[] = {75, 25, 8, 3, 0.5, -1.5, -4.5};
    static const double views[] = {70, 20, 5, 0.5}, azimuths[] = {5, 100};
    static const double spectra[] = {SPECTRUM_RGB, 3, 6}, most_mean[] = {8, 1.5, 0.1}, most[] = {40, 12, 0.5};
    static const double most_luminance[] = {3, 0.15, 0.01};
    for (int s = 0; s < 3; s++) {
        double mean = 0, largest = 0, luminance = 0;
        enum { ROWS = 3 * 7 * 4 * 2 * 2 };
        static double many[ROWS][3];
        for (int k = 0; k < ROWS; k++) {
            Atmosphere air = air_of(k % 2 ? "simmons2017-ozone" : "simmons2017", spectra[s]);
            double height = heights[k / 2 % 3], rgb[3], view[3], sun[3];
            for (int c = 0; c < 3; c++) air.sun_irradiance[c] = 1;
            unit_vector(views[k / 42 % 4], azimuths[k / 168], view);
            unit_vector(suns[k / 6 % 7], 0, sun);
            SkyTruth *truth = sky_truth_create(&air, NULL);
            sky_truth_ask(truth, height, view, sun, rgb);
            sky_truth_destroy(truth);
            if (s == 0) sky_by_many(&air, height, view, sun, many[k]);
            double difference = colors_difference_of_hues(rgb, many[k]);
            mean += difference / ROWS;
            largest = fmax(largest, difference);
            luminance = fmax(luminance, fabs(colors_luminance(rgb) / colors_luminance(many[k]) - 1));
        }
        print_message("spectrum %g: dE mean %.3f, max %.3f; luminance off by %.2f %% at most\n", spectra[s],
                      mean, largest, 100 * luminance);
        assert_true(mean < most_mean[s] && largest < most[s] && luminance < most_luminance[s]);
    }
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

/* The same with all orders of scattering, over a ground, by the GPU's harmonics: of the many wavelengths and
 * of the few. */
static void test_orders_against_many(void **state) {
    (void)state;
    enum { VIEWS = 8, SKIES = 15, ROWS = SKIES * VIEWS };
    static const double suns[] = {70, 15, 3, -0.5, -5.5}, heights[] = {1, 2500, 12000};
    static const double spectra[] = {3, 6}, most_mean[] = {2, 0.1}, most[] = {12, 0.5},
                        most_luminance[] = {0.15, 0.01};
    static float directions[4 * VIEWS], got[4 * VIEWS];
    static double shares[ROWS][COLORS_SAMPLES];
    Atmosphere air = air_of("earth", SPECTRUM_RGB), channels = air;
    Context context;
    SkyProbe probe;
    Error error;
    support_open(&context);
    assert_true(atmosphere_set(&air, "ground_albedo", "0.5,0.3,0.1", &error));
    for (int c = 0; c < 3; c++) air.sun_irradiance[c] = 1;
    for (int i = 0; i < VIEWS; i++) {
        double view[3];
        unit_vector(1 + 10.5 * i, 70 * i, view);
        for (int c = 0; c < 3; c++) directions[4 * i + c] = (float)view[c];
    }
    open_probe(&context, &probe, "gauss:12", &channels);
    for (int first = 0; first < COLORS_SAMPLES; first += 3) {
        double nm[3];
        for (int c = 0; c < 3; c++) nm[c] = colors_wavelength_nm(first + c);
        for (int k = 0; k < SKIES; k++) {
            SkyState sky = {spectrum_air_at(&air, nm), sun_at(suns[k / 3], 0, 0.2666)};
            sky.atmosphere.observer_height_m = heights[k % 3];
            if (!sky_probe_ask(&probe, &sky, directions, VIEWS, got, &error)) fail_msg("%s", error.text);
            for (int i = 0; i < 3 * VIEWS; i++)
                shares[k * VIEWS + i / 3][first + i % 3] = (double)got[4 * (i / 3) + i % 3];
        }
    }
    sky_probe_destroy(&probe);
    for (int s = 0; s < 2; s++) {
        double mean = 0, largest = 0, luminance = 0;
        air.spectrum = spectra[s];
        open_probe(&context, &probe, "gauss:12", &air);
        for (int k = 0; k < SKIES; k++) {
            SkyState sky = {air, sun_at(suns[k / 3], 0, 0.2666)};
            sky.atmosphere.observer_height_m = heights[k % 3];
            if (!sky_probe_ask(&probe, &sky, directions, VIEWS, got, &error)) fail_msg("%s", error.text);
            for (int i = 0; i < VIEWS; i++) {
                double rgb[3], many[3];
                for (int c = 0; c < 3; c++) rgb[c] = (double)got[4 * i + c];
                colors_of_shares(shares[k * VIEWS + i], many);
                double difference = colors_difference_of_hues(rgb, many);
                mean += difference / ROWS;
                largest = fmax(largest, difference);
                luminance = fmax(luminance, fabs(colors_luminance(rgb) / colors_luminance(many) - 1));
            }
        }
        print_message("all orders, spectrum %g: dE mean %.3f, max %.3f; luminance off by %.2f %% at most\n",
                      spectra[s], mean, largest, 100 * luminance);
        assert_true(mean < most_mean[s] && largest < most[s] && luminance < most_luminance[s]);
        sky_probe_destroy(&probe);
    }
    context_close(&context);
}

enum { DIRECTIONS = 150 };

/* RMS of the three channels' errors, percent, each over the luminance of the truth or over a thousandth of
 * the mean luminance. */
static double probe_error(SkyProbe *probe, const Atmosphere *atmosphere, double sun_deg, const double *truth,
                          const float *directions) {
    static float got[4 * DIRECTIONS];
    SkyState state = {*atmosphere, sun_at(sun_deg, 20, 0.2666)};
    Error error;
    double squares = 0, mean = 0;
    for (int i = 0; i < DIRECTIONS; i++) mean += colors_luminance(truth + 3 * i) / DIRECTIONS;
    if (!sky_probe_ask(probe, &state, directions, DIRECTIONS, got, &error)) fail_msg("%s", error.text);
    for (int i = 0; i < 3 * DIRECTIONS; i++) {
        double off = ((double)got[4 * (i / 3) + i % 3] - truth[i]) /
                     fmax(colors_luminance(truth + 3 * (i / 3)), 1e-3 * mean);
        assert_true(isfinite(off));
        squares += off * off;
    }
    return 100 * sqrt(squares / (3 * DIRECTIONS));
}

/* The GPU's methods with a spectrum, above the horizon, against the reference of the same wavelengths. They
 * are as accurate as without: those of rgb are printed beside. */
static void test_methods(void **state) {
    (void)state;
    static const struct {
        const char *method;
        double day, twilight;
    } cases[] = {{"gauss:12", 0.01, 0.2},
                 {"gauss:8", 0.03, 0.5},
                 {"table:gauss:12@64x192", 0.02, 2},
                 {"paper:128x32", 0.5, 1.5}};
    static const double suns[] = {60, 20, 5, 0, -3, -6}, spectra[] = {SPECTRUM_RGB, 3, 6};
    static float directions[4 * DIRECTIONS];
    static double truth[6][3 * DIRECTIONS];
    Context context;
    support_open(&context);
    for (int i = 0; i < DIRECTIONS; i++) {
        double view[3];
        unit_vector(asin(fmod(0.5 + 0.75487766624669276 * i, 1)) / degree + 0.01,
                    360 * fmod(0.56984029 * i, 1), view);
        for (int c = 0; c < 3; c++) directions[4 * i + c] = (float)view[c];
    }
    for (int s = 0; s < 3; s++) {
        Atmosphere air = air_of("simmons2017-ozone", spectra[s]);
        SkyTruth *solved = sky_truth_create(&air, NULL);
        for (int k = 0; k < 6 * DIRECTIONS; k++) {
            const float *direction = directions + 4 * (k / 6);
            double view[3] = {(double)direction[0], (double)direction[1], (double)direction[2]};
            Sun sun = sun_at(suns[k % 6], 20, 0.2666);
            sky_truth_ask(solved, 1, view, sun.direction, truth[k % 6] + 3 * (k / 6));
        }
        sky_truth_destroy(solved);
        for (size_t m = 0; m < sizeof cases / sizeof *cases; m++) {
            SkyProbe probe;
            open_probe(&context, &probe, cases[m].method, &air);
            print_message("spectrum %g, %s:", spectra[s], cases[m].method);
            for (int k = 0; k < 6; k++) {
                double rms = probe_error(&probe, &air, suns[k], truth[k], directions);
                print_message(" %.4f", rms);
                if (!(rms < (suns[k] > 0 ? cases[m].day : cases[m].twilight)))
                    fail_msg("sun %g: off by %.3f %%", suns[k], rms);
            }
            print_message(" %%\n");
            sky_probe_destroy(&probe);
        }
    }
    context_close(&context);
}

static void test_roots(void **state) {
    (void)state;
    static const float values[] = {0, 1, -1, 16, -16, 1e-12f, -1e-12f, 3e4f, -3e4f, -0.37f, 0.37f, -1e-30f};
    enum { COUNT = sizeof values / sizeof *values };
    float inputs[4 * COUNT] = {0}, results[4 * COUNT];
    Context context;
    support_open(&context);
    for (int i = 0; i < COUNT; i++) inputs[4 * i] = values[i];
    support_evaluate(&context,
                     "#include \"sky/root_signed.glsl\"\nuniform sampler2D inputs;\n"
                     "vec4 evaluate(vec2 texel) {\n"
                     "    vec3 v = texelFetch(inputs, ivec2(texel), 0).rgb, root = fourth_root(v);\n"
                     "    return vec4(root.x, fourth_power(root));\n}\n",
                     inputs, COUNT, 1, results);
    for (int i = 0; i < COUNT; i++) {
        double value = (double)values[i], root = (double)results[4 * i];
        assert_true(fabs(root - copysign(pow(fabs(value), 0.25), value)) <= 1e-6 * fabs(root) + 1e-12);
        assert_true(fabs((double)results[4 * i + 1] - value) <= 2e-6 * fabs(value));
    }
    context_close(&context);
}

/* Colours outside of sRGB have components below 0. They reach a map's file and a picture's, and every
 * estimator takes them. */
static void test_negative(void **state) {
    (void)state;
    static const char *const pictures[] = {"--light cosine", "--light control", "--light mis"};
    Image image;
    Error error;
    int negative = 0;
    support_expect(0, "",
                   "sky -o '%s' --size 64x32 --sun -4 --atmosphere simmons2017-ozone --set "
                   "atmosphere.spectrum=6 --quiet",
                   support_path("map.exr"));
    assert_true(image_read(&image, support_path("map.exr"), &error));
    for (int i = 0; i < 4 * 64 * 32; i++) {
        assert_true(isfinite(image.rgba[i]));
        negative += image.rgba[i] < 0;
    }
    image_free(&image);
    assert_true(negative > 5);
    double means[3][3];
    for (int k = 0; k < 3; k++) {
        support_expect(0, "",
                       "render scenes/crater.glsl -o '%s' --size 48x32 --spp 256 --sun -4 --atmosphere "
                       "simmons2017-ozone "
                       "--set atmosphere.spectrum=6 --quiet %s",
                       support_path("picture.exr"), pictures[k]);
        assert_true(image_read(&image, support_path("picture.exr"), &error));
        memset(means[k], 0, sizeof means[k]);
        for (int i = 0; i < 3 * 48 * 32; i++) {
            assert_true(isfinite(image.rgba[4 * (i / 3) + i % 3]));
            means[k][i % 3] += (double)image.rgba[4 * (i / 3) + i % 3] / (48 * 32);
        }
        for (int c = 0; c < 3; c++) assert_true(fabs(means[k][c] / means[0][c] - 1) < 0.02);
        image_free(&image);
    }
}

/* `sky --at --spectrum`: columns named by their wavelengths, for the sun as it is. */
static void test_command(void **state) {
    (void)state;
    static const char *const methods[] = {"reference", "gauss:12", "table:gauss:12@64x192"};
    static const double nm[4] = {400, 475.5, 640, 830};
    const char *csv = support_write("rows.csv", "1,30,20,40\n1,30,70,150\n2000,3,5,10\n");
    for (int m = 0; m < 3; m++) {
        double value[4], view[3], sun[3], expected[3];
        support_expect(0, "",
                       "sky --at '%s' --sky %s --atmosphere simmons2017-ozone --spectrum=400,475.5,640,830",
                       csv, methods[m]);
        const char *header = "height_m,sun_el_deg,view_el_deg,az_deg,L_400,L_475.5,L_640,L_830\n";
        assert_ptr_equal(support_out, strstr(support_out, header));
        assert_int_equal(sscanf(support_out + strlen(header), "1,30,20,40,%lf,%lf,%lf,%lf\n", &value[0],
                                &value[1], &value[2], &value[3]),
                         4);
        Atmosphere earth = air_of("simmons2017-ozone", SPECTRUM_RGB), air = spectrum_air_at(&earth, nm + 1);
        unit_vector(20, 40, view);
        unit_vector(30, 0, sun);
        sky_reference(&air, 1, view, sun, expected);
        for (int c = 0; c < 3; c++) {
            double wanted = expected[c] * spectrum_sun_per_nm(nm[c + 1]);
            assert_true(fabs(value[c + 1] / wanted - 1) < (m ? 1e-3 : 1e-8));
        }
    }
    support_expect(0, "", "sky --at '%s' --sky gauss:12 --spectrum=360:830:10", csv);
    assert_non_null(strstr(support_out, "az_deg,L_360,L_370,"));
    assert_non_null(strstr(support_out, ",L_830\n"));
    support_expect(0, "", "sky --at '%s' --sky gauss:12 --spectrum --set atmosphere.spectrum=3", csv);
    Atmosphere few = air_of("simmons2017-ozone", 3);
    double few_nm[MOST_WAVELENGTHS];
    char columns[80];
    spectrum_wavelengths(&few, few_nm);
    snprintf(columns, sizeof columns, "az_deg,L_%g,L_%g,L_%g\n", few_nm[0], few_nm[1], few_nm[2]);
    assert_non_null(strstr(support_out, columns));
    support_expect(2, "magichour: --spectrum: atmosphere.spectrum is rgb: list the wavelengths",
                   "sky --at '%s' --spectrum", csv);
    support_expect(2, "magichour: --spectrum: 355 is outside the range from 360 to 830",
                   "sky --at '%s' --spectrum=355,400", csv);
    support_expect(2, "magichour: --spectrum: '' is not", "sky --at '%s' --spectrum=400,,500", csv);
    support_expect(2, "magichour: --spectrum: a range is", "sky --at '%s' --spectrum=500:400:10", csv);
    support_expect(2, "magichour: --spectrum: a spectrum needs",
                   "sky --at '%s' --atmosphere simmons2017-author --spectrum=400", csv);
    support_expect(2, "magichour: --spectrum is for --at alone", "sky -o '%s' --spectrum=400",
                   support_path("no.exr"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_colors),
        cmocka_unit_test(test_matrices),
        cmocka_unit_test(test_laws),
        cmocka_unit_test(test_refused),
        cmocka_unit_test(test_disk),
        cmocka_unit_test(test_against_many),
        cmocka_unit_test(test_orders_against_many),
        cmocka_unit_test(test_methods),
        cmocka_unit_test(test_roots),
        cmocka_unit_test(test_negative),
        cmocka_unit_test(test_command),
    };
    return cmocka_run_group_tests_name("spectrum", tests, support_folder, support_clean);
}
