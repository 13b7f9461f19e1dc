/* The atmosphere's air between the surfaces: what its annotation may say, its switch, how it turns light, the
 * light of a way through it, furnaces, and the horizon. */
#include "base/vec3.h"
#include "drivers.h"
#include "mist.h"
#include "scene/atmosphere.h"
#include "scene/spectrum.h"
#include "scene/sun.h"
#include "sky/air_path.h"
#include "sky/scene_air.h"
#include "sky/sky_reference.h"
#include "support.h"
#include "ztest.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static void test_errors(void **state) {
    (void)state;
    static const struct {
        const char *annotation, *error;
    } cases[] = {
        {"//@ air", ":3: air needs on or off"},
        {"//@ air 0.1", ":3: air needs on or off; its coefficients are the atmosphere's"},
        {"//@ air on extinction 0.1", ":3: air: unknown word 'extinction': its coefficients are"},
        {"//@ air on\n//@ air off", ":4: air is there already, in line 3"},
        {"uniform float air; //@ slider 1\n//@ air on", ":4: air is switched by a parameter of its name"},
        {"//@ preset a air on", ":3: "},
        {"//@ airs on", ":3: unknown annotation 'airs': did you mean air?"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *scene = mist_ball("wrong.glsl", cases[i].annotation, "0.5");
        int status = support_run("", "info '%s'", scene);
        if (status != STATUS_SCENE || !strstr(support_err, cases[i].error))
            fail_msg("%s: status %d, \"%s\" lacks \"%s\"", cases[i].annotation, status, support_err,
                     cases[i].error);
    }
}

/* Air that is switched off is not there, to the bit. What is not computed with it is refused. */
static void test_switch(void **state) {
    (void)state;
    static const char arguments[] = "--size 24x24 --spp 16 --sun-disk=sampled";
    static const struct {
        const char *annotations, *way;
        bool there;
    } cases[] = {
        {"//@ air on", "", true},
        {"//@ air off", "", false},
        {"//@ air on", "--set air=off", false},
        {"//@ air off", "--set air=on", true},
        {"//@ air on\n//@ preset clear air off", "--preset clear", false},
        {"//@ mist extinction 0.1 below 1\n//@ air on", "--set air=off --set mist=off", false},
    };
    Image clear = mist_render("", mist_ball("clear.glsl", "", "0.5"), arguments);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char words[256];
        snprintf(words, sizeof words, "%s %s", arguments, cases[i].way);
        Image got = mist_render("", mist_ball("air.glsl", cases[i].annotations, "0.5"), words);
        bool same = memcmp(got.rgba, clear.rgba, sizeof(float[4 * 24 * 24])) == 0;
        if (same == cases[i].there) fail_msg("%s, %s", cases[i].annotations, cases[i].way);
        image_free(&got);
    }
    image_free(&clear);
    const char *scene = mist_ball("air.glsl", "//@ air on", "0.5"), *none = support_path("none.pfm");
    support_expect(STATUS_USAGE, "light paths do not know the air between the surfaces, which",
                   "render '%s' --sun-disk=traced -o '%s'", scene, none);
    assert_int_equal(support_run("", "info '%s'", scene), 0);
    assert_non_null(strstr(support_out, "  air on\n"));
    assert_non_null(strstr(support_out, "--set air=1"));
    scene = mist_ball("both.glsl", "//@ mist extinction 0.1 below 1\n//@ air on", "0.5");
    support_expect(STATUS_SCENE, "both.glsl:4: air and mist (line 3) are not computed together",
                   "render '%s' -o '%s'", scene, none);
    /* Neither is turned on beside the other to see what it is worth. */
    scene =
        mist_ball("either.glsl", "//@ sky uniform:1\n//@ mist off extinction 0.1 below 1\n//@ air on", "0.5");
    assert_int_equal(support_run("", "explain '%s' --size 8x8", scene), 0);
    assert_non_null(strstr(support_out, "  mist (the scene's)                       -"));
    support_expect(STATUS_USAGE, "has no setting 'air'", "render '%s' --set air=off -o '%s'",
                   mist_ball("clear.glsl", "", "0.5"), none);
}

/* The two phase functions together integrate to the scattering that the material has, and samples weigh as
 * they do; Rayleigh's alone, aerosols' alone, and both. */
static void test_phase(void **state) {
    (void)state;
    enum { SIDE = 512, TEXELS = SIDE * SIDE, BINS = 64 };
    static const char *const densities[] = {"1.0, 0.0", "0.0, 1.0", "1.0, 0.3"};
    static float results[4 * TEXELS];
    Context context;
    support_open(&context);
    for (int i = 0; i < 3; i++) {
        double total = 0, sampled[BINS] = {0}, expected[BINS] = {0}, chi2 = 0, mean = 0;
        char glsl[4096];
        snprintf(
            glsl, sizeof glsl,
            "#include \"math/hash.glsl\"\n#include \"mist/material/place_air.glsl\"\n"
            "Atmosphere air_here() { return Atmosphere(6360.0e3, 60.0e3, 7994.0, 1200.0, vec3(1.0), "
            "vec3(1.5), "
            "vec3(1.5), 0.76, vec3(0.0), 25.0e3, 15.0e3, vec3(20.0)); }\n"
            "vec4 evaluate(vec2 t) {\n    vec3 axis = normalize(vec3(0.3, -0.8, 0.5));\n"
            "    Material m = air_material(air_here(), vec2(%s));\n"
            "    float w = (t.y * 512.0 + t.x + 0.5) / 131072.0 - 1.0;\n"
            "    vec3 out_ = in_frame(axis, sqrt(1.0 - w * w), 0.0, w);\n"
            "    uvec3 h = hash_3(uvec3(uvec2(t), 7u)), k = hash_3(uvec3(uvec2(t), 8u));\n"
            "    Bounce b = place_air_sample(m, vec3(0.0), axis, vec2(unit_float(h.x), unit_float(h.y)), "
            "vec2(unit_float(k.x), 0.0));\n"
            "    float s = m.roughness + 1.5 * m.ior;\n"
            "    return vec4(4.0 * PI * place_air_value(m, vec3(0.0), axis, out_).x / s, w, dot(axis, "
            "b.direction), "
            "b.weight.x / s);\n}",
            densities[i]);
        support_evaluate(&context, glsl, NULL, SIDE, SIDE, results);
        for (int k = 0; k < TEXELS; k++) {
            const float *v = results + 4 * k;
            total += (double)v[0] / TEXELS;
            mean += (double)v[3] / TEXELS;
            expected[(int)fmin(32 + 32 * (double)v[1], 63)] += (double)v[0];
            sampled[(int)fmin(fmax(32 + 32 * (double)v[2], 0), 63)] += (double)v[3];
        }
        /* Weights are at most 3 / (2 + g^2), which widens a bin's spread. */
        for (int k = 0; k < BINS; k++) chi2 += pow(sampled[k] - expected[k], 2) / (expected[k] * 1.5);
        print_message("densities %s: integral %.5f, mean weight %.5f, chi-square %.0f of %d\n", densities[i],
                      total, mean, chi2, BINS);
        assert_true(fabs(total - 1) < 2e-3 && fabs(mean - 1) < 2e-3);
        assert_true(ztest_chi_square(chi2, BINS - 1) < ztest_limit(3));
    }
    context_close(&context);
}

/* A black wall at a distance, seen through air that scatters sunlight once. */
typedef struct Wall {
    const char *atmosphere, *settings;
    double distance_m, pitch_deg;
} Wall;

/* Whether the planet is round, and whether each wavelength has an extinction of its own. */
typedef struct Laws {
    bool round, spectral;
} Laws;

static double rayleigh_phase(double nu) {
    return 3 / (16 * pi) * (1 + nu * nu);
}

static double mie_phase(double g, double nu) {
    return 3 / (8 * pi) * (1 - g * g) * (1 + nu * nu) / ((2 + g * g) * pow(1 + g * g - 2 * g * nu, 1.5));
}

/* The light of a band at a step of the way, before the colours are made: what is scattered there in a metre.
 */
static void scattered_there(const Atmosphere *air, double height, double nu, const double sun[3],
                            double light[3]) {
    double kept[3], density[2] = {air_molecule_density(air, height), air_aerosol_density(air, height)};
    sky_reference_transmittance(air, height, sun, kept);
    for (int k = 0; k < 3; k++)
        light[k] = air->sun_irradiance[k] * kept[k] *
                   (air->rayleigh * air->rayleigh_scatter_per_m[k] * density[0] * rayleigh_phase(nu) +
                    air->mie * air->mie_scatter_per_m[k] * density[1] * mie_phase(air->mie_g, nu));
}

/* The radiance of the way by the midpoint rule in double precision. The columns back to the eye are summed
 * along. */
static void wall_quadrature(const Atmosphere *atmosphere, const Wall *wall, Laws laws, double radiance[3]) {
    enum { STEPS = 2000 };
    Sun sun = sun_at(30, 140, 0.2666);
    double step = wall->distance_m / STEPS, slope = sin(wall->pitch_deg * degree);
    double nu = slope * sun.direction[1] + cos(wall->pitch_deg * degree) * sun.direction[2];
    double start = atmosphere->observer_height_m + 1, columns[3] = {0};
    SceneAir channels = scene_air(atmosphere);
    for (int c = 0; c < 3; c++) radiance[c] = 0;
    for (int i = 0; i < STEPS; i++) {
        double t = (i + 0.5) * step, height = start + t * slope, rgb[3] = {0};
        double radius = atmosphere->planet_radius_m + start;
        if (laws.round) height = air_altitude_along(start, radius, radius * slope, t);
        double density[3] = {air_molecule_density(atmosphere, height),
                             air_aerosol_density(atmosphere, height), air_ozone_density(atmosphere, height)};
        for (int k = 0; k < 3; k++) columns[k] += 0.5 * step * density[k];
        for (int band = 0; band < spectrum_bands(atmosphere); band++) {
            Atmosphere air = spectrum_band(atmosphere, band);
            double light[3];
            scattered_there(&air, height, nu, sun.direction, light);
            AirColumns seen = {columns[0], columns[1], columns[2]};
            for (int k = 0; laws.spectral && k < 3; k++) light[k] *= exp(-air_extinction(&air, &seen, k));
            spectrum_add(atmosphere, band, light, rgb);
        }
        for (int c = 0; c < 3; c++) {
            double depth = channels.rayleigh_scatter[c] * columns[0] +
                           channels.mie_extinction[c] * columns[1] + channels.ozone_absorb[c] * columns[2];
            radiance[c] += step * rgb[c] * (laws.spectral ? 1 : exp(-depth));
        }
        for (int k = 0; k < 3; k++) columns[k] += 0.5 * step * density[k];
    }
}

static Atmosphere wall_atmosphere(const Wall *wall) {
    Atmosphere atmosphere;
    Error error;
    if (!atmosphere_choose(&atmosphere, wall->atmosphere, &error)) fail_msg("%s", error.text);
    atmosphere.orders = 1;
    for (int c = 0; c < 3; c++) atmosphere.ground_albedo[c] = 0;
    return atmosphere;
}

/* The light of the way is the integral over it, within the noise; and it is near to the integral of the sky's
 * own air, which is round and has a spectrum. */
static void test_wall(void **state) {
    (void)state;
    static const struct {
        Wall wall;
        double own_percent;
    } cases[] = {
        {{"simmons2017", "", 100, 0}, 0.01}, {{"simmons2017", "", 2000, 10}, 0.01},
        {{"simmons2017", "", 2e4, 0}, 0.2},  {{"simmons2017", "", 2e4, 20}, 0.2},
        {{"simmons2017", "", 1e5, 0.5}, 3},  {{"simmons2017-ozone", "", 6e4, 30}, 0.5},
        {{"earth", "", 2000, 0}, 0.2},       {{"earth", "", 2e4, 5}, 1.5},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const Wall *wall = &cases[i].wall;
        Atmosphere atmosphere = wall_atmosphere(wall);
        char text[2048], arguments[256];
        double pitch = wall->pitch_deg * degree, got[3], error[3], wanted[3], own[3], worst = 0,
               worst_own = 0;
        snprintf(text, sizeof text,
                 "//@ sun elevation 30 azimuth 140\n//@ camera eye 0 1 0 target 0 %.9g %.9g fov 0.01\n"
                 "//@ atmosphere %s\n//@ air on\n#include \"material/matte.glsl\"\n"
                 "void scene_intersect(Ray ray, INOUT(Hit) hit) {\n"
                 "    if (ray.direction.z > 0.5 && %g < hit.t) {\n        hit.t = float(%g);\n"
                 "        hit.normal = vec3(0.0, 0.0, -1.0);\n        hit.object = 0;\n    }\n}\n"
                 "Material scene_material(Hit hit) { return matte(vec3(0.0)); }\n",
                 1 + 100 * sin(pitch), 100 * cos(pitch), wall->atmosphere, wall->distance_m,
                 wall->distance_m);
        snprintf(arguments, sizeof arguments,
                 "--size 64x64 --spp %d --set atmosphere.orders=1 --set atmosphere.ground_albedo=0",
                 (int)support_samples(64));
        Image image = mist_render("", support_write("wall.glsl", text), arguments);
        mist_means(&image, got, error);
        image_free(&image);
        wall_quadrature(&atmosphere, wall, (Laws){0}, wanted);
        wall_quadrature(&atmosphere, wall, (Laws){true, true}, own);
        for (int c = 0; c < 3; c++) {
            assert_true(fabs(got[c] - wanted[c]) < 5 * error[c] + 1e-4 * wanted[c]);
            worst = fmax(worst, 100 * fabs(got[c] / wanted[c] - 1));
            worst_own = fmax(worst_own, 100 * fabs(wanted[c] / own[c] - 1));
        }
        print_message(
            "%s, %g m at %g degrees: %.4f %.4f %.4f, off by %.3f %%; off the round air's by %.3f %%\n",
            wall->atmosphere, wall->distance_m, wall->pitch_deg, got[0], got[1], got[2], worst, worst_own);
        if (support_block() == 1) assert_true(worst < 0.1);
        assert_true(worst_own < cases[i].own_percent);
    }
}

/* Air that only scatters, among white surfaces under a sky of 1, cannot be seen. It is as thin as the
 * Earth's, and up to 30,000 times as thick. */
static void test_furnace(void **state) {
    (void)state;
    static const char *const airs[] = {
        "rayleigh=1 --set atmosphere.mie=1", "rayleigh=1000 --set atmosphere.mie=2000",
        "rayleigh=30000 --set atmosphere.mie=0", "rayleigh=0 --set atmosphere.mie=3000",
        "rayleigh=1e4 --set atmosphere.rayleigh_scatter_per_m=3e-5,0,1e-6"};
    static const char *const lights[] = {"cosine", "mis", "control", "portal"};
    enum { AIRS = sizeof airs / sizeof *airs, CASES = 4 * AIRS };
    double all = 0, all_variance = 0;
    for (int i = 0; i < CASES; i++) {
        char arguments[256];
        double mean[3] = {0}, squares[3] = {0};
        snprintf(arguments, sizeof arguments,
                 "--size 128x128 --seed %d --spp %d --light %s --set atmosphere.mie_extinction_ratio=1 --set "
                 "atmosphere.%s",
                 i, (int)support_samples(128), lights[i % 4], airs[i / 4]);
        Image image =
            mist_render("", mist_ball("furnace.glsl", "//@ sky uniform:1\n//@ air on", "1.0"), arguments);
        int pixels = image.width * image.height;
        mist_means(&image, mean, NULL);
        for (int k = 0; k < 4 * pixels; k++)
            if (k % 4 < 3) squares[k % 4] += pow((double)image.rgba[k] - 1, 2);
        image_free(&image);
        for (int c = 0; c < 3; c++) {
            double variance = squares[c] / pixels / pixels;
            if (fabs(mean[c] - 1) > ztest_limit(3 * CASES) * sqrt(variance) + 1e-5)
                fail_msg("%s: %.6f in channel %d, standard error %.6f", arguments, mean[c], c,
                         sqrt(variance));
            all += (mean[c] - 1) / (3 * CASES);
            all_variance += variance / (9 * CASES * CASES);
        }
    }
    print_message("all: %+.6f, standard error at most %.6f\n", all, sqrt(3 * all_variance));
    assert_true(fabs(all) < 4 * sqrt(3 * all_variance) + 1e-5);
}

/* A plane of the planet's albedo is at the horizon nearly as bright as the sky above it: both are the same
 * air. The sky's air is round, so that the way rises into brighter and less reddened sunlight. */
static void test_horizon(void **state) {
    (void)state;
    static const struct {
        const char *atmosphere;
        double percent;
    } cases[] = {{"simmons2017", 18}, {"earth", 15}};
    for (int i = 0; i < 6; i++) {
        static const int elevations[] = {60, 30, 5};
        char annotations[256];
        double sky[3] = {0}, plane[3] = {0}, worst = 0;
        enum { COLUMNS = 16, ROWS = 64 };
        snprintf(
            annotations, sizeof annotations,
            "//@ camera eye 0 1 -4 target 0 1 -5 fov 0.01\n//@ sun-disk on\n//@ air on\n//@ atmosphere %s",
            cases[i / 3].atmosphere);
        char arguments[128];
        snprintf(arguments, sizeof arguments, "--size 16x64 --spp %d --set sun.elevation=%d",
                 (int)support_samples(1024), elevations[i % 3]);
        Image image = mist_render("", mist_ball("horizon.glsl", annotations, "0.1"), arguments);
        for (int k = 0; k < COLUMNS; k++) {
            for (int c = 0; c < 3; c++) {
                sky[c] += (double)image.rgba[4 * ((ROWS / 2 - 1) * COLUMNS + k) + c] / COLUMNS;
                plane[c] += (double)image.rgba[4 * (ROWS / 2 * COLUMNS + k) + c] / COLUMNS;
            }
        }
        image_free(&image);
        for (int c = 0; c < 3; c++) worst = fmax(worst, 100 * fabs(plane[c] / sky[c] - 1));
        print_message("%s, sun at %d: the plane is off the sky by %+.1f %+.1f %+.1f %%\n",
                      cases[i / 3].atmosphere, elevations[i % 3], 100 * (plane[0] / sky[0] - 1),
                      100 * (plane[1] / sky[1] - 1), 100 * (plane[2] / sky[2] - 1));
        assert_true(sky[0] > 0.01 && worst < cases[i / 3].percent);
    }
}

/* Mesa's two software drivers, as in test_mist_pictures. */
static void test_drivers(void **state) {
    (void)state;
    static const char *const lights[] = {"cosine", "mis", "control", "portal"};
    const char *scene = mist_ball("drivers.glsl", "//@ air on\n//@ sun-disk on\n//@ sky uniform:1", "0.5");
    drivers_need_both();
    for (int l = 0; l < 4; l++) {
        char arguments[256];
        snprintf(arguments, sizeof arguments,
                 "--size 16x16 --spp %d --seed 5 --light %s --set atmosphere.rayleigh=300 --set "
                 "atmosphere.mie=300 --set atmosphere.rayleigh_scale_height_m=20 --set "
                 "atmosphere.mie_scale_height_m=10",
                 (int)support_samples(64), lights[l]);
        DriversDifference drivers = drivers_compare(scene, arguments);
        print_message("%s: %d values differ, the others' bias %.1e\n", lights[l], drivers.differ,
                      drivers.bias_of_same);
        assert_true(drivers.differ <= drivers.values / 32);
        assert_true(fabs(drivers.bias_of_same) < 1e-5);
    }
}

int main(int argc, char **argv) {
    if (argc > 1) cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_errors),  cmocka_unit_test(test_switch),  cmocka_unit_test(test_phase),
        cmocka_unit_test(test_wall),    cmocka_unit_test(test_furnace), cmocka_unit_test(test_horizon),
        cmocka_unit_test(test_drivers),
    };
    return cmocka_run_group_tests_name("air", tests, support_folder, support_clean);
}
