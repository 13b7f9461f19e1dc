/* How finely the CPU computes the further orders of scattering (sky/sky_orders.h), and who watches it. */
#pragma once

#include "base/error.h"

enum { SKY_ORDERS_MOST = 12 };

/* How finely the field of an order is computed. */
typedef struct SkyOrderPlan {
    /* The degree of its harmonics, and of those that the next field is computed from: 2 at least. */
    int degree, onward;
    /* The directions: elevations above and below the horizon, and azimuths in half a turn. */
    int above, below, azimuths;
} SkyOrderPlan;

typedef struct SkyOrdersPlan {
    /* The grid: altitudes, elevations of the sun, and the points of an interpolation along each (2 or 4). */
    int rows, columns, points;
    /* Nodes of the quadrature on each part of a ray (26 at most), and of the last one, toward the eye (48).
     */
    int nodes, last_nodes;
    /* Whether a share of the aerosols' scattering, which stands for the harmonics beyond the first order's
     * degree, is taken as not scattered at all. It makes a low degree more accurate. What goes with it is
     * sky_orders_first() alone, because the true single scattering loses that share. */
    bool peak;
    /* The fields that are computed: 2 at least. Those beyond are a geometric series. No field has a higher
     * degree than the first. */
    int orders;
    SkyOrderPlan order[SKY_ORDERS_MOST];
} SkyOrdersPlan;

/* Watches a long computation: go_on() gets the share that is done, and returns false to stop. */
typedef struct SkyWatch {
    bool (*go_on)(void *state, double share);
    void *state;
} SkyWatch;

/* How often the filling of tables asks its watch. */
#define SKY_WATCH_SECONDS 0.2

/* Fails with STATUS_INTERRUPTED if there is a watch that stops the work. */
MUST_CHECK static inline bool sky_watch_ask(const SkyWatch *watch, double share, Error *error) {
    if (!watch || watch->go_on(watch->state, share)) return true;
    return error_set(error, STATUS_INTERRUPTED, "interrupted while tables were filled");
}
