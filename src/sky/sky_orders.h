/* The orders of scattering beyond the first, in double precision on the CPU: the ground truth of the shaders'
 * further light (glsl/sky/README.md). It shares none of their code, and has columns in closed form
 * (sky/air_column.h), quadratures and interpolations of its own.
 *
 * Light that was scattered k times, by the air or by the ground, has the order k. At a point its radiance
 * depends on the direction, the altitude and the local elevation of the sun, but neither on the observer nor
 * on the place. So the field of each order is computed once, on a grid (sky/orders_field.h), from the field
 * of the order before. The light that is seen is gathered along the view's ray from the sum of all fields. */
#pragma once

#include "scene/atmosphere.h"

#include <stdbool.h>

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

/* The plan of the ground truth. */
extern const SkyOrdersPlan sky_orders_plan;

/* Watches the solution: go_on() gets the share that is done, and returns false to stop. */
typedef struct SkyWatch {
    bool (*go_on)(void *state, double share);
    void *state;
} SkyWatch;

typedef struct SkyOrders SkyOrders;

/* Solves for an air and a ground with as many orders as the atmosphere says. It takes about 20 seconds by
 * sky_orders_plan, and no time if only one order counts. The observer's height and the sun's irradiance have
 * no influence. `watch` may be NULL. Returns NULL if it was stopped. */
SkyOrders *sky_orders_create(const Atmosphere *atmosphere, const SkyOrdersPlan *plan, const SkyWatch *watch);
void sky_orders_destroy(SkyOrders *orders);

/* The radiance of all light of the orders from the second on, for a sun of irradiance 1. The arguments are
 * those of sky_reference(). */
void sky_orders_radiance(const SkyOrders *orders, double height_m, const double view[3], const double sun[3],
                         double radiance[3]);

/* The radiance of order 1, for a sun of irradiance 1: sunlight scattered by the air, and by the ground. It is
 * as accurate as the quadrature of the plan's last nodes. */
void sky_orders_first(const SkyOrders *orders, double height_m, const double view[3], const double sun[3],
                      double radiance[3]);
