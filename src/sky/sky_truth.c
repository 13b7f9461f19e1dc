#include "sky/sky_truth.h"

#include "base/memory.h"
#include "scene/spectrum.h"
#include "sky/sky_reference.h"

#include <stdlib.h>

struct SkyTruth {
    Atmosphere atmosphere;
    SkyOrders *orders[MOST_BANDS];
};

/* A watch over one of several bands. */
typedef struct BandWatch {
    const SkyWatch *whole;
    int band, bands;
} BandWatch;

static bool watch_band(void *state, double share) {
    const BandWatch *watch = state;
    if (!watch->whole) return true;
    return watch->whole->go_on(watch->whole->state, (watch->band + share) / watch->bands);
}

SkyTruth *sky_truth_create(const Atmosphere *atmosphere, const SkyWatch *watch) {
    SkyTruth *truth = memory_get(1, sizeof *truth);
    BandWatch state = {.whole = watch, .bands = spectrum_bands(atmosphere)};
    SkyWatch part = {watch_band, &state};
    truth->atmosphere = *atmosphere;
    for (; state.band < state.bands; state.band++) {
        Atmosphere air = spectrum_band(atmosphere, state.band);
        truth->orders[state.band] = sky_orders_create(&air, &sky_orders_plan, &part);
        if (truth->orders[state.band]) continue;
        sky_truth_destroy(truth);
        return NULL;
    }
    return truth;
}

void sky_truth_destroy(SkyTruth *truth) {
    if (!truth) return;
    for (int band = 0; band < MOST_BANDS; band++) sky_orders_destroy(truth->orders[band]);
    free(truth);
}

void sky_truth_ask(const SkyTruth *truth, double height_m, const double view[3], const double sun[3],
                   double radiance[3]) {
    const Atmosphere *atmosphere = &truth->atmosphere;
    for (int c = 0; c < 3; c++) radiance[c] = 0;
    for (int band = 0; band < spectrum_bands(atmosphere); band++) {
        Atmosphere air = spectrum_band(atmosphere, band);
        double channels[3], ground[3], further[3];
        sky_reference(&air, height_m, view, sun, channels);
        sky_reference_ground(&air, height_m, view, sun, ground);
        sky_orders_radiance(truth->orders[band], height_m, view, sun, further);
        for (int c = 0; c < 3; c++) channels[c] += ground[c] + air.sun_irradiance[c] * further[c];
        spectrum_add(atmosphere, band, channels, radiance);
    }
}
