/* All orders of scattering on the GPU: against another program's radiances and irradiances, against the same
 * computation in double, at the ends of what may be set, and the balance of the light. */
#include "skies.h"
#include "support.h"

#include "base/vec3.h"
#include "sky/observer.h"
#include "sky/orders_plan.h"
#include "sky/sky_orders.h"
#include "sky/sky_probe.h"
#include "sky/sky_reference.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Context context;
static bool is_open;

static int close_context(void **state) {
    (void)state;
    if (is_open) context_close(&context);
    return 0;
}

static void open_probe(SkyProbe *probe, const char *sky, const char *further, const Atmosphere *air) {
    MethodChoice choice;
    Error error;
    if (!is_open) support_open(&context);
    is_open = true;
    if (!method_choose(&choice, METHOD_SKY, sky, &error) ||
        !sky_probe_create(probe, &context, support_sources(), &choice, air, &error) ||
        !method_choose(&probe->further, METHOD_FURTHER, further, &error)) {
        fail_msg("%s", error.text);
    }
}

static void ask_probe(SkyProbe *probe, const Atmosphere *air, double sun_deg, const double (*directions)[3],
                      int count, double (*radiances)[3]) {
    SkyState state = {*air, sun_at(sun_deg, 0, 0.2666)};
    Error error;
    float *values = calloc((size_t)count, 4 * sizeof *values);
    for (int i = 0; i < count; i++) {
        for (int c = 0; c < 3; c++) values[4 * i + c] = (float)directions[i][c];
    }
    if (!sky_probe_ask(probe, &state, values, (size_t)count, values, &error)) fail_msg("%s", error.text);
    for (int i = 0; i < count; i++) {
        for (int c = 0; c < 3; c++) radiances[i][c] = (double)values[4 * i + c];
    }
    free(values);
}

/* The rows of every `step`-th air. */
static void expect_rows(const char *sky, const char *further, int step,
                        const SkiesBounds bounds[SKIES_CLASSES]) {
    static SkiesRow rows[SKIES_MOST_ROWS];
    SkiesErrors *errors = calloc(1, sizeof *errors);
    char name[80];
    bool few = support_samples(SKIES_AIRS) == 1;
    int count = skies_radiances(rows);
    for (int number = few ? 1 : step - 1; number < (few ? 2 : SKIES_AIRS); number += step) {
        Atmosphere air = skies_air(number);
        SkyProbe probe;
        open_probe(&probe, sky, further, &air);
        for (int i = 0; i < count; i++) {
            double view[1][3], got[1][3];
            if (rows[i].air != number) continue;
            air.observer_height_m = rows[i].height_m;
            skies_direction(rows[i].view_deg, rows[i].azimuth_deg, view[0]);
            ask_probe(&probe, &air, rows[i].sun_deg, view, 1, got);
            skies_errors_add(errors, rows[i].sun_deg, got[0], rows[i].total);
        }
        sky_probe_destroy(&probe);
    }
    snprintf(name, sizeof name, "%s, %s", sky, further);
    skies_errors_expect(errors, name, bounds);
    free(errors);
}

static void test_rows_10(void **state) {
    (void)state;
    static const SkiesBounds bounds[] = {{0.4, 1.5}, {0.5, 2}, {0.7, 2.5}, {2.5, 10}};
    expect_rows("gauss:12", "harmonics:10", 1, bounds);
}

static void test_rows_14(void **state) {
    (void)state;
    static const SkiesBounds bounds[] = {{0.25, 0.9}, {0.35, 1.3}, {0.45, 1.5}, {2, 6}};
    expect_rows("gauss:12", "harmonics:14", 1, bounds);
}

static void test_rows_table(void **state) {
    (void)state;
    static const SkiesBounds bounds[] = {{0.4, 1.5}, {0.5, 2}, {0.7, 2.5}, {2.5, 10}};
    expect_rows("table", "harmonics:10", 3, bounds);
}

/* The largest error is in blue above the brightest ground, where the orders beyond those computed count most.
 */
static void test_irradiances(void **state) {
    (void)state;
    static SkiesRow rows[SKIES_MOST_ROWS];
    static SkiesDome dome;
    static double radiances[SKIES_DOME][3];
    int count = skies_irradiances(rows), airs = support_samples(SKIES_AIRS) > 1 ? SKIES_AIRS : 1;
    double worst[3] = {0};
    skies_dome(&dome);
    for (int number = 0; number < airs; number++) {
        Atmosphere air = skies_air(number);
        SkyProbe probe;
        open_probe(&probe, "gauss:12", "harmonics:10", &air);
        for (int i = 0; i < count; i++) {
            if (rows[i].air != number) continue;
            double sum[3] = {0}, *of = &worst[rows[i].sun_deg >= 0 ? 0 : rows[i].sun_deg >= -6 ? 1 : 2];
            air.observer_height_m = rows[i].height_m;
            ask_probe(&probe, &air, rows[i].sun_deg, dome.directions, SKIES_DOME, radiances);
            for (int k = 0; k < SKIES_DOME; k++) {
                for (int c = 0; c < 3; c++) sum[c] += dome.weights[k] * radiances[k][c];
            }
            for (int c = 0; c < 3; c++) *of = fmax(*of, 100 * fabs(sum[c] / rows[i].total[c] - 1));
        }
        sky_probe_destroy(&probe);
    }
    print_message("irradiance: off by %.3f %% at most with the sun up, %.3f %% down to -6, %.3f %% below\n",
                  worst[0], worst[1], worst[2]);
    assert_true(worst[0] < 0.3 && worst[1] < 0.5);
}

/* The texels of the table of further light, so that no interpolation of it counts (glsl/sky/table.glsl). */
enum { SIDE = 32, TEXELS = 2 * SIDE * SIDE };

static void set_texels(const Atmosphere *air, double (*directions)[3]) {
    double horizon = sky_horizon_sine(air), limb = sky_limb_sine(air);
    for (int i = 0; i < TEXELS; i++) {
        double x = i % SIDE / (SIDE - 1.0), y = i / SIDE % SIDE / (SIDE - 1.0), along = y * y * y * y;
        double share = fmax(along * (2 - along), 1e-7), end = i >= TEXELS / 2 ? -1 : limb;
        double sine = fmin(fmax(horizon + share * (end - horizon), -1), 1),
               level = sqrt((1 - sine) * (1 + sine));
        directions[i][2] = level * (1 - 2 * x);
        directions[i][1] = sine;
        directions[i][0] = level * sqrt(1 - (1 - 2 * x) * (1 - 2 * x));
    }
}

/* The GPU's plan, for the solver in double. */
static SkyOrdersPlan plan_of(int degree_wanted) {
    const OrdersPlan *gpu = orders_plan(degree_wanted);
    SkyOrdersPlan plan = {.rows = gpu->rows,
                          .columns = gpu->columns,
                          .points = 2,
                          .nodes = 8,
                          .last_nodes = 8,
                          .peak = true,
                          .orders = ORDER_FIELDS};
    for (int k = 0; k < ORDER_FIELDS; k++) {
        const OrderPlan *order = &gpu->orders[k];
        plan.order[k] = (SkyOrderPlan){.degree = order->degree,
                                       .onward = gpu->orders[k + 1 < ORDER_FIELDS ? k + 1 : k].degree,
                                       .above = order->above,
                                       .below = order->below,
                                       .azimuths = order->azimuths};
    }
    return plan;
}

/* Compares the table's texels for a sun, relative to the radiance or to a thousandth of its mean. Row 0, on
 * the horizon itself, is not looked up exactly. */
static void compare_with_double(const SkyOrders *orders, double height, double sun_deg,
                                const double (*directions)[3], const double (*got)[3], double *rms,
                                double *largest) {
    static double expected[TEXELS][3];
    double squares = 0, mean = 0, sun[3], first[3];
    int count = 0;
    skies_direction(sun_deg, 0, sun);
    for (int i = 0; i < TEXELS; i++) {
        sky_orders_radiance(orders, height, directions[i], sun, expected[i]);
        sky_orders_first(orders, height, directions[i], sun, first);
        for (int c = 0; c < 3; c++) expected[i][c] = 20 * (expected[i][c] + first[c]);
        mean += expected[i][1] / TEXELS;
    }
    *largest = 0;
    for (int i = 0; i < 3 * TEXELS; i++) {
        int texel = i / 3, c = i % 3;
        if (texel / SIDE % SIDE == 0) continue;
        double error = fabs(got[texel][c] - expected[texel][c]) / fmax(expected[texel][c], 1e-3 * mean);
        squares += error * error;
        *largest = fmax(*largest, error);
        count++;
    }
    *rms = sqrt(squares / count);
}

/* The same quadratures, harmonics and interpolations, in float and in double. Where the paths are short
 * enough, the difference is that of float alone. Elsewhere it is that of the columns of air back to the eye,
 * which the GPU sums from the nodes. Three more things differ: the last column of the grid, a tenth of a
 * degree off the zenith on the GPU; the floor of the light; and sunlight in deep twilight, which depends on
 * metres at the planet's edge. */
static void test_against_double(void **state) {
    (void)state;
    static const double heights[] = {2e3, 1, 60e3, 4e5}, suns[] = {45, 5, -1, -3, 90, -9, -18};
    static double directions[TEXELS][3], got[TEXELS][3];
    SkyOrdersPlan plan = plan_of(10);
    Atmosphere air = skies_air(4);
    SkyOrders *orders = sky_orders_create(&air, &plan, NULL);
    SkyProbe probe;
    open_probe(&probe, "gauss:8", "harmonics:10", &air);
    for (int i = 0; i < 4 * 7; i++) {
        double height = heights[i / 7], sun_deg = suns[i % 7], rms, largest;
        bool exact = i / 7 == 0 && i % 7 < 4;
        air.observer_height_m = height;
        set_texels(&air, directions);
        ask_probe(&probe, &air, sun_deg, directions, TEXELS, got);
        compare_with_double(orders, height, sun_deg, directions, got, &rms, &largest);
        print_message("%g m, sun %g: RMS %.1e, largest %.1e\n", height, sun_deg, rms, largest);
        assert_true(rms < (exact ? 1e-5 : 1e-3) && largest < (exact ? 1e-4 : 3e-3));
    }
    sky_orders_destroy(orders);
    sky_probe_destroy(&probe);
}

typedef struct Asked {
    SkyProbe probe;
    Atmosphere air;
} Asked;

static void ask_from_top(void *state, double sun_deg, const double (*directions)[3], int count,
                         double (*radiances)[3]) {
    Asked *asked = state;
    ask_probe(&asked->probe, &asked->air, sun_deg, directions, count, radiances);
}

/* Air and ground that absorb nothing: all light leaves through the top. */
static void test_furnace(void **state) {
    (void)state;
    Asked asked = {.air = skies_air(2)};
    double shares[3];
    asked.air.mie_extinction_ratio = 1;
    asked.air.observer_height_m = 60e3;
    for (int c = 0; c < 3; c++) asked.air.ground_albedo[c] = 1;
    open_probe(&asked.probe, "gauss:12", "harmonics:10", &asked.air);
    skies_balance(&asked.air, ask_from_top, &asked, shares);
    sky_probe_destroy(&asked.probe);
    print_message("white air and ground: %.5f %.5f %.5f of the light comes out\n", shares[0], shares[1],
                  shares[2]);
    for (int c = 0; c < 3; c++) assert_true(fabs(shares[c] - 1) < 0.005);
}

static void expect_finite(SkyProbe *probe, Atmosphere *air) {
    static const double heights[] = {0, 5e3, 60e3, 1e6}, suns[] = {90, 0, -18};
    static double directions[TEXELS][3], got[TEXELS][3];
    for (int i = 0; i < 4 * 3; i++) {
        air->observer_height_m = heights[i % 4];
        set_texels(air, directions);
        ask_probe(probe, air, suns[i / 4], directions, TEXELS, got);
        for (int k = 0; k < 3 * TEXELS; k++) {
            double value = got[k / 3][k % 3];
            if (!(isfinite(value) && value >= 0 && value < 1e3))
                fail_msg("%g m, sun %g, density %g, g %g: texel %d: %g", heights[i % 4], suns[i / 4],
                         air->rayleigh, air->mie_g, k / 3, value);
        }
    }
}

static void test_extremes(void **state) {
    (void)state;
    static const double densities[] = {0, 1, 100}, gs[] = {-0.9, 0.5, 0.9};
    int steps = support_samples(64) > 1 ? 2 : 8;
    for (int ozone = 0; ozone < 2; ozone++) {
        Atmosphere air = skies_air(ozone ? 5 : 2);
        SkyProbe probe;
        open_probe(&probe, "gauss:8", "harmonics:10", &air);
        for (int i = ozone; i < 9; i += steps) {
            air.rayleigh = air.mie = densities[i % 3];
            air.mie_g = gs[i / 3];
            expect_finite(&probe, &air);
        }
        sky_probe_destroy(&probe);
    }
}

/* By one order, the ground adds albedo / pi times the sunlight that arrives. */
static void test_one_order(void **state) {
    (void)state;
    static const double heights[] = {1, 3e3, 60e3}, suns[] = {90, 30, 4};
    static double directions[TEXELS][3], got[TEXELS][3];
    Atmosphere air = skies_air(5);
    double worst = 0;
    SkyProbe probe;
    air.orders = 1;
    open_probe(&probe, "gauss:12", "harmonics:10", &air);
    for (int i = 0; i < 9; i++) {
        air.observer_height_m = heights[i % 3];
        set_texels(&air, directions);
        ask_probe(&probe, &air, suns[i / 3], directions, TEXELS, got);
        /* Well below the horizon. */
        for (int k = TEXELS / 2 + SIDE * SIDE / 3; k < TEXELS; k += 7) {
            double sun[3], ground[3], sky[3];
            skies_direction(suns[i / 3], 0, sun);
            sky_reference(&air, heights[i % 3], directions[k], sun, sky);
            sky_reference_ground(&air, heights[i % 3], directions[k], sun, ground);
            for (int c = 0; c < 3; c++) worst = fmax(worst, fabs(got[k][c] / (sky[c] + ground[c]) - 1));
        }
    }
    sky_probe_destroy(&probe);
    print_message("one order and the ground: off by %.1e at most\n", worst);
    assert_true(worst < 1e-3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rows_10),        cmocka_unit_test(test_rows_14),
        cmocka_unit_test(test_rows_table),     cmocka_unit_test(test_irradiances),
        cmocka_unit_test(test_against_double), cmocka_unit_test(test_furnace),
        cmocka_unit_test(test_extremes),       cmocka_unit_test(test_one_order),
    };
    return cmocka_run_group_tests_name("further light", tests, NULL, close_context);
}
