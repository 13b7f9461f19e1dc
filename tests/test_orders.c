/* All orders of scattering on the CPU: the harmonics, phase functions as sums of them, columns in closed
 * form, and the solution by a coarse plan against another program's. tests/test_orders_rows.c has the
 * reference's own plan.
 */
#include "skies.h"
#include "support.h"

#include "base/vec3.h"
#include "sky/air_column.h"
#include "sky/gauss_table.h"
#include "sky/harmonics.h"
#include "sky/sky_reference.h"
#include "sky/sky_truth.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* About a second. */
static const SkyOrdersPlan coarse = {
    .rows = 14,
    .columns = 48,
    .points = 4,
    .nodes = 6,
    .last_nodes = 10,
    .orders = 4,
    .order = {{12, 6, 10, 5, 10}, {6, 4, 6, 3, 6}, {4, 4, 6, 3, 6}, {4, 4, 6, 3, 6}}};

/* A fifth of that, and more orders: for what holds by any plan. */
static const SkyOrdersPlan rough = {.rows = 8,
                                    .columns = 32,
                                    .points = 2,
                                    .nodes = 5,
                                    .last_nodes = 8,
                                    .orders = 8,
                                    .order = {{6, 4, 8, 4, 8},
                                              {4, 4, 5, 3, 5},
                                              {4, 4, 5, 3, 5},
                                              {4, 4, 5, 3, 5},
                                              {4, 4, 5, 3, 5},
                                              {4, 4, 5, 3, 5},
                                              {4, 4, 5, 3, 5},
                                              {4, 4, 5, 3, 5}}};

enum { DEGREE = 14 };

/* Gauss's quadrature in the cosine and midpoints in the azimuth are both exact for products of two harmonics.
 */
static void test_harmonics(void **state) {
    (void)state;
    enum { NODES = DEGREE + 2, AROUND = DEGREE + 1, COUNT = (DEGREE + 1) * (DEGREE + 2) / 2 };
    static HarmonicStep steps[COUNT];
    static double products[COUNT][COUNT];
    double u[NODES], w[NODES], y[COUNT], worst = 0;
    assert_int_equal(harmonics_count(DEGREE), COUNT);
    harmonics_steps(DEGREE, steps);
    gauss_nodes(NODES, u, w);
    for (int i = 0; i < NODES * AROUND; i++) {
        harmonics_at(steps, DEGREE, 2 * u[i / AROUND] - 1, cos(pi * (i % AROUND + 0.5) / AROUND), y);
        for (int k = 0; k < COUNT * COUNT; k++)
            products[k / COUNT][k % COUNT] += 4 * pi / AROUND * w[i / AROUND] * y[k / COUNT] * y[k % COUNT];
    }
    for (int k = 0; k < COUNT * COUNT; k++)
        worst = fmax(worst, fabs(products[k / COUNT][k % COUNT] - (k / COUNT == k % COUNT)));
    print_message("%d harmonics: orthonormal to %.1e\n", COUNT, worst);
    assert_true(worst < 1e-13);
}

static double legendre(int l, double x) {
    double p = 1, before = 0;
    for (int k = 1; k <= l; k++) {
        double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p, p = next;
    }
    return p;
}

static double mie_phase(double g, double nu) {
    return 3 / (8 * pi) * (1 - g * g) * (1 + nu * nu) / ((2 + g * g) * pow(1 + g * g - 2 * g * nu, 1.5));
}

/* Panels that halve toward both ends, where the peak is. */
static void test_phase(void **state) {
    (void)state;
    static const double gs[] = {-0.9, -0.5, 0, 0.3, 0.76, 0.9, 0.99};
    double u[16], w[16], chi[DEGREE + 1], worst = 0;
    gauss_nodes(16, u, w);
    for (size_t i = 0; i < sizeof gs / sizeof *gs; i++) {
        double sums[DEGREE + 1] = {0};
        harmonics_mie(gs[i], DEGREE, chi);
        for (double width = 1; width > 1e-13; width /= 2) {
            for (int k = 0; k < 32; k++) {
                double sign = k < 16 ? 1 : -1, nu = sign * (1 - width * (0.5 + u[k % 16] / 2));
                double part = pi * width * w[k % 16] * mie_phase(gs[i], nu);
                for (int l = 0; l <= DEGREE; l++) sums[l] += part * legendre(l, nu);
            }
        }
        for (int l = 0; l <= DEGREE; l++) worst = fmax(worst, fabs(sums[l] - chi[l]));
    }
    print_message("Legendre coefficients of the aerosols' phase function: right to %.1e\n", worst);
    assert_true(worst < 1e-6);
}

static void test_columns(void **state) {
    (void)state;
    Atmosphere air = skies_air(3);
    double worst[3] = {0}, top = air_top_height(&air);
    for (int i = 0; i < 40; i++) {
        double height = top * pow(i / 40.0, 3), radius = air.planet_radius_m + height;
        double horizon = -sqrt(height * (2 * air.planet_radius_m + height)) / radius;
        for (int k = 0; k <= 60; k++) {
            double rise = radius * (horizon + (1 - horizon) * pow(k / 60.0, 3)) + 1e-6;
            AirColumns got = air_column_to_top(&air, height, rise);
            double length = air_distance_out(rise, air_square_above(&air, top, height));
            AirColumns right = air_columns(&air, height, rise, length);
            worst[0] = fmax(worst[0], fabs(got.air - right.air) / right.air);
            worst[1] = fmax(worst[1], fabs(got.aerosol - right.aerosol) / right.aerosol);
            worst[2] = fmax(worst[2], fabs(got.ozone - right.ozone) / fmax(right.ozone, 1));
        }
    }
    print_message("columns in closed form: air to %.1e, aerosols to %.1e, ozone to %.1e\n", worst[0],
                  worst[1], worst[2]);
    assert_true(worst[0] < 1e-5 && worst[1] < 1e-5 && worst[2] < 1e-8);
}

/* The single scattering of the rows is that of the reference, so the errors are the further orders'. */
static void test_rows(void **state) {
    (void)state;
    static const SkiesBounds bounds[] = {{0.2, 0.7}, {0.31, 1.05}, {0.66, 2.9}, {7.8, 28}};
    static SkiesRow rows[SKIES_MOST_ROWS];
    static SkiesErrors errors;
    int count = skies_radiances(rows);
    int airs = support_samples(SKIES_AIRS) > 1 ? SKIES_AIRS : 1;
    for (int air = 0; air < airs; air++) {
        Atmosphere atmosphere = skies_air(air);
        SkyOrders *orders = sky_orders_create(&atmosphere, &coarse, NULL);
        for (int i = 0; i < count; i++) {
            double view[3], sun[3], total[3], ground[3];
            if (rows[i].air != air) continue;
            skies_direction(rows[i].view_deg, rows[i].azimuth_deg, view);
            skies_direction(rows[i].sun_deg, 0, sun);
            sky_orders_radiance(orders, rows[i].height_m, view, sun, total);
            sky_reference_ground(&atmosphere, rows[i].height_m, view, sun, ground);
            for (int c = 0; c < 3; c++) total[c] = rows[i].single[c] + ground[c] + 20 * total[c];
            skies_errors_add(&errors, rows[i].sun_deg, total, rows[i].total);
        }
        sky_orders_destroy(orders);
    }
    skies_errors_expect(&errors, "the coarse plan", bounds);
}

/* The share of light that gets from the ground up to a height, in a direction: what gets on from there to the
 * top is divided out. */
static void share_up(const Atmosphere *air, double height, double elevation_deg, double out[3]) {
    double from_ground[3], from_height[3], radius = air->planet_radius_m, up[3];
    double level = radius * cos(elevation_deg * degree) / (radius + height);
    skies_direction(elevation_deg, 0, up);
    sky_reference_transmittance(air, 0, up, from_ground);
    sky_reference_transmittance(air, height, (double[3]){0, sqrt((1 - level) * (1 + level)), level},
                                from_height);
    for (int c = 0; c < 3; c++) out[c] = from_ground[c] / from_height[c];
}

/* With one order the ground adds albedo / pi times the sunlight that reaches it, and nothing else. The view
 * down at an elevation, seen from the ground, is tilted by the angle between both places. */
static void test_ground(void **state) {
    (void)state;
    static const double heights[] = {0, 100, 5000, 59000}, suns[] = {90, 30, 2, -1}, steep[] = {90, 40, 5};
    Atmosphere air = skies_air(5), black = skies_air(3);
    air.orders = black.orders = 1;
    SkyTruth *lit = sky_truth_create(&air, NULL), *dark = sky_truth_create(&black, NULL);
    double worst = 0;
    for (int i = 0; i < 4 * 4 * 3; i++) {
        double height = heights[i % 4], sun_deg = suns[i / 4 % 4], elevation = steep[i / 16];
        double radius = air.planet_radius_m + height,
               level = air.planet_radius_m * cos(elevation * degree) / radius;
        double below = acos(level) / degree, place = below - elevation, view[3], sun[3], got[3], plain[3];
        double up[3], down[3];
        skies_direction(-below, 0, view);
        skies_direction(sun_deg, 0, sun);
        sky_truth_ask(lit, height, view, sun, got);
        sky_truth_ask(dark, height, view, sun, plain);
        /* The ground is met nearer to the sun. */
        double local = sun_deg == 90 && place > 0 ? 90 - place : sun_deg + place;
        skies_direction(local, 0, sun);
        sky_reference_transmittance(&air, 0, sun, down);
        share_up(&air, height, elevation, up);
        for (int c = 0; c < 3; c++) {
            double expected = 20 * 0.8 / pi * fmax(sin(local * degree), 0) * down[c] * up[c];
            worst = fmax(worst, fabs(got[c] - plain[c] - expected) / (expected + 1e-3));
        }
    }
    print_message("sunlight from the ground: right to %.1e\n", worst);
    assert_true(worst < 1e-7);
    sky_truth_destroy(lit);
    sky_truth_destroy(dark);
}

/* Order 1 as the solver has it, which all others come from. It takes no notice of the kinks in the ozone,
 * which is most of its error. */
static void test_first(void **state) {
    (void)state;
    Atmosphere air = skies_air(4);
    SkyOrdersPlan plan = rough;
    double squares = 0, worst = 0;
    int count = 0;
    air.orders = 1;
    plan.last_nodes = 20;
    SkyOrders *orders = sky_orders_create(&air, &plan, NULL);
    for (int i = 0; i < 300; i++) {
        static const double heights[] = {0, 1, 2000, 30e3, 60e3, 2e5}, suns[] = {90, 40, 8, 1, -2, -5};
        double view[3], sun[3], got[3], expected[3], ground[3];
        skies_direction(-80 + 160 * fmod(0.5 + 0.7548776662 * i, 1), 180 * fmod(0.5698402910 * i, 1), view);
        skies_direction(suns[i / 6 % 6], 0, sun);
        sky_orders_first(orders, heights[i % 6], view, sun, got);
        sky_reference(&air, heights[i % 6], view, sun, expected);
        sky_reference_ground(&air, heights[i % 6], view, sun, ground);
        for (int c = 0; c < 3; c++) {
            double error = fabs(20 * got[c] - expected[c] - ground[c]) / fmax(expected[c] + ground[c], 1e-4);
            squares += error * error;
            worst = fmax(worst, error);
            count++;
        }
    }
    print_message("order 1: RMS %.1e, largest %.1e\n", sqrt(squares / count), worst);
    assert_true(sqrt(squares / count) < 1e-4 && worst < 1e-3);
    sky_orders_destroy(orders);
}

/* The red, green and blue of some views together, for a number of orders. */
static double light_of(double orders_wanted, int computed, double lights[3]) {
    Atmosphere air = skies_air(2);
    SkyOrdersPlan plan = rough;
    double sum = 0;
    air.orders = orders_wanted;
    plan.orders = computed;
    SkyOrders *orders = sky_orders_create(&air, &plan, NULL);
    memset(lights, 0, 3 * sizeof *lights);
    for (int i = 0; i < 3; i++) {
        double view[3], sun[3], radiance[3];
        skies_direction(10 + 35 * i, 40, view);
        skies_direction(20, 0, sun);
        sky_orders_radiance(orders, 1, view, sun, radiance);
        for (int c = 0; c < 3; c++) lights[i] += radiance[c];
        sum += lights[i];
    }
    sky_orders_destroy(orders);
    return sum;
}

/* Each order adds light, the less the more there are, and the series that stands for the last ones agrees
 * with their computation. */
static void test_count(void **state) {
    (void)state;
    double lights[3], before = 0, step = INFINITY, computed[10], all = light_of(INFINITY, 8, lights);
    assert_true(light_of(1, 8, lights) == 0);
    for (int n = 2; n <= 9; n++) {
        computed[n] = light_of(n, 8, lights);
        print_message("orders 2 to %d: %.5f of all\n", n, computed[n] / all);
        assert_true(computed[n] > before && computed[n] < all && computed[n] - before < step);
        step = computed[n] - before;
        before = computed[n];
    }
    for (int n = 6; n <= 9; n++) assert_true(fabs(light_of(n, 4, lights) / computed[n] - 1) < 2e-3);
    assert_true(fabs(light_of(1000, 8, lights) / all - 1) < 1e-9);
    assert_true(fabs(light_of(INFINITY, 4, lights) / all - 1) < 2e-3);
}

static void ask_orders(void *state, double sun_deg, const double (*directions)[3], int count,
                       double (*radiances)[3]) {
    SkyOrders *orders = state;
    double sun[3], further[3];
    skies_direction(sun_deg, 0, sun);
    for (int i = 0; i < count; i++) {
        sky_orders_first(orders, 60e3, directions[i], sun, radiances[i]);
        sky_orders_radiance(orders, 60e3, directions[i], sun, further);
        for (int c = 0; c < 3; c++) radiances[i][c] = 20 * (radiances[i][c] + further[c]);
    }
}

/* Air and ground that absorb nothing: all light leaves through the top. */
static void test_furnace(void **state) {
    (void)state;
    for (int peak = 0; peak < 2; peak++) {
        Atmosphere air = skies_air(2);
        SkyOrdersPlan plan = coarse;
        double shares[3];
        air.mie_extinction_ratio = 1;
        for (int c = 0; c < 3; c++) air.ground_albedo[c] = 1;
        plan.peak = peak;
        SkyOrders *orders = sky_orders_create(&air, &plan, NULL);
        skies_balance(&air, ask_orders, orders, shares);
        sky_orders_destroy(orders);
        print_message("white air and ground%s: %.5f %.5f %.5f of the light comes out\n",
                      peak ? ", without the peak" : "", shares[0], shares[1], shares[2]);
        for (int c = 0; c < 3; c++) assert_true(fabs(shares[c] - 1) < 0.005);
    }
}

static void expect_finite(const SkyOrders *orders) {
    static const double heights[] = {0, 1, 5e3, 60e3, 1e6}, suns[] = {90, 30, 0, -6, -18};
    static const double views[] = {90, 20, 0, -0.5, -30, -90};
    for (int i = 0; i < 5 * 5 * 6 * 2; i++) {
        double view[3], sun[3], got[3];
        skies_direction(views[i / 25 % 6], 180 * (i / 150), view);
        skies_direction(suns[i / 5 % 5], 0, sun);
        sky_orders_radiance(orders, heights[i % 5], view, sun, got);
        for (int c = 0; c < 3; c++) {
            if (!(isfinite(got[c]) && got[c] >= 0 && got[c] < 1))
                fail_msg("height %g, sun %g, view %g: %g", heights[i % 5], suns[i / 5 % 5], views[i / 25 % 6],
                         got[c]);
        }
    }
}

static void test_extremes(void **state) {
    (void)state;
    static const double densities[] = {0, 0.01, 1, 100}, gs[] = {-0.9, 0, 0.9};
    SkyOrdersPlan plan = rough;
    plan.orders = 3;
    for (int i = 0; i < 4 * 3 * 2; i++) {
        Atmosphere air = skies_air(i % 2 ? 5 : 2);
        air.rayleigh = air.mie = densities[i / 2 % 4];
        air.mie_g = gs[i / 8];
        plan.peak = i % 3 == 0;
        SkyOrders *orders = sky_orders_create(&air, &plan, NULL);
        expect_finite(orders);
        sky_orders_destroy(orders);
    }
}

static bool stop_late(void *state, double share) {
    double *last = state;
    assert_true(share > *last && share <= 1);
    *last = share;
    return share < 0.6;
}

static void test_watch(void **state) {
    (void)state;
    Atmosphere air = skies_air(0);
    double last = 0;
    SkyWatch watch = {stop_late, &last};
    assert_null(sky_orders_create(&air, &rough, &watch));
    assert_true(last >= 0.6);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_harmonics), cmocka_unit_test(test_phase),   cmocka_unit_test(test_columns),
        cmocka_unit_test(test_first),     cmocka_unit_test(test_ground),  cmocka_unit_test(test_rows),
        cmocka_unit_test(test_count),     cmocka_unit_test(test_furnace), cmocka_unit_test(test_extremes),
        cmocka_unit_test(test_watch),
    };
    return cmocka_run_group_tests_name("orders", tests, NULL, NULL);
}
