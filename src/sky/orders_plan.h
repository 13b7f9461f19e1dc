/* How finely the orders of scattering beyond the first are computed on the GPU (glsl/sky/README.md). */
#pragma once

#include "scene/atmosphere.h"

enum { ORDER_FIELDS = 4, ORDERS_MOST_ELEVATIONS = 32, ORDERS_MOST_DEGREE = 24 };

/* The field of light that was scattered k times. */
typedef struct OrderPlan {
    /* Its harmonics go up to this degree. */
    int degree;
    /* The directions in which it is computed: elevations above and below the horizon, and azimuths in half a
     * turn. */
    int above, below, azimuths;
} OrderPlan;

typedef struct OrdersPlan {
    /* The grid of moments: elevations of the sun across, altitudes along. */
    int columns, rows;
    /* The fields that are computed; the rest is a geometric series. No degree is above the one before. */
    OrderPlan orders[ORDER_FIELDS];
} OrdersPlan;

/* The plan of the quality whose field of order 1 has this degree: 8, 10 or 14; NULL if there is none. */
const OrdersPlan *orders_plan(int degree);

int order_directions(const OrderPlan *order);

/* The grid's columns are even in asinh((middle - chord) * closeness), from `left` to `right`. The chord is
 * that of the angle from the zenith, sqrt(2 - 2 sine): it is as smooth as the angle. Columns are closest
 * where the sun is 3 degrees below the horizon, and lie from -20 degrees to the zenith. */
typedef struct OrdersColumns {
    double middle, closeness, left, right;
} OrdersColumns;

OrdersColumns orders_columns(void);

/* The share of the light scattered by aerosols that is taken as not scattered at all, because it goes on
 * nearly straight. It stands for the harmonics beyond the degree. */
double orders_peak(const Atmosphere *atmosphere, const OrdersPlan *plan);

/* The share of the aerosols' extinction that is left on the way to the eye without that light. It is 1 for an
 * air of one order. */
double orders_kept(const Atmosphere *atmosphere, const OrdersPlan *plan);

/* The weights of scattering by aerosols, by degree; 0 beyond that of order 1. */
void orders_weights(const Atmosphere *atmosphere, const OrdersPlan *plan,
                    double weights[ORDERS_MOST_DEGREE + 1]);
