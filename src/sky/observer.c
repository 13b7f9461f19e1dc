#include "sky/observer.h"

#include "sky/orders.h"

#include <math.h>

double sky_horizon_sine(const Atmosphere *atmosphere) {
    double r = atmosphere->planet_radius_m, h = atmosphere->observer_height_m;
    return -sqrt(h * (2 * r + h)) / (r + h);
}

double sky_limb_sine(const Atmosphere *atmosphere) {
    double r = atmosphere->planet_radius_m, h = atmosphere->observer_height_m;
    double top = atmosphere->top_radius_m - r;
    return h > top ? -sqrt((h - top) * (2 * r + h + top)) / (r + h) : 1;
}

void sky_key(const void *frame, Text *key) {
    const SkyState *state = &((const Frame *)frame)->state;
    orders_key(frame, key);
    text_append(key, &state->atmosphere, sizeof state->atmosphere);
    text_append(key, &state->sun.elevation_deg, sizeof state->sun.elevation_deg);
    /* What is made from a coarse table is coarse too. */
    text_append(key, &((const Frame *)frame)->coarse, sizeof(bool));
}
