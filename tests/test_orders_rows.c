/* The reference of all orders of scattering (sky/sky_truth.h) against another program's radiances and
 * irradiances: half a minute for each air. */
#include "skies.h"
#include "support.h"

#include "sky/sky_truth.h"

#include <math.h>
#include <stdio.h>

static double irradiance_error(const SkyTruth *truth, const SkiesDome *dome, const SkiesRow *row) {
    double sum[3] = {0}, worst = 0, sun[3];
    skies_direction(row->sun_deg, 0, sun);
    for (int k = 0; k < SKIES_DOME; k++) {
        double radiance[3];
        sky_truth_ask(truth, row->height_m, dome->directions[k], sun, radiance);
        for (int c = 0; c < 3; c++) sum[c] += dome->weights[k] * radiance[c];
    }
    for (int c = 0; c < 3; c++) worst = fmax(worst, 100 * fabs(sum[c] / row->total[c] - 1));
    return worst;
}

static void test_rows(void **state) {
    (void)state;
    static const SkiesBounds bounds[] = {{0.06, 0.2}, {0.06, 0.25}, {0.12, 0.55}, {0.5, 1.6}};
    static SkiesRow rows[SKIES_MOST_ROWS], irradiances[SKIES_MOST_ROWS];
    static SkiesErrors errors;
    static SkiesDome dome;
    int count = skies_radiances(rows), others = skies_irradiances(irradiances),
        step = support_samples(2) > 1 ? 1 : 2;
    double worst[2] = {0};
    skies_dome(&dome);
    /* One with ozone and one without. */
    for (int air = 4; air > 0; air -= 2 * step) {
        Atmosphere atmosphere = skies_air(air);
        SkyTruth *truth = sky_truth_create(&atmosphere, NULL);
        for (int i = 0; i < count; i++) {
            double view[3], sun[3], got[3];
            if (rows[i].air != air) continue;
            skies_direction(rows[i].view_deg, rows[i].azimuth_deg, view);
            skies_direction(rows[i].sun_deg, 0, sun);
            sky_truth_ask(truth, rows[i].height_m, view, sun, got);
            skies_errors_add(&errors, rows[i].sun_deg, got, rows[i].total);
        }
        for (int i = 0; i < others; i++) {
            double *of = &worst[irradiances[i].sun_deg < -6];
            if (irradiances[i].air == air) *of = fmax(*of, irradiance_error(truth, &dome, &irradiances[i]));
        }
        sky_truth_destroy(truth);
    }
    print_message("irradiance: off by %.3f %% at most down to -6, %.3f %% below\n", worst[0], worst[1]);
    skies_errors_expect(&errors, "the reference", bounds);
    assert_true(worst[0] < 0.2 && worst[1] < 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_rows)};
    return cmocka_run_group_tests_name("orders' rows", tests, NULL, NULL);
}
