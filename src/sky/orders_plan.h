/* How finely the orders of scattering beyond the first are computed (glsl/sky/README.md), on the GPU
 * (sky/further.h) and on the CPU (sky/sky_orders.h). */
#pragma once

#include "scene/atmosphere.h"

enum { ORDERS_MOST_ELEVATIONS = 32, ORDERS_MOST_DEGREE = 24 };

typedef struct OrdersPlan {
    /* The grid of moments: elevations of the sun across, altitudes along. */
    int columns, rows;
    /* The harmonics' degree of the field of order 1 in the last gathering, and of all else. */
    int first_degree, degree;
    /* Directions of the quadrature of the field of order 1: elevations above and below the horizon, azimuths
     * in half a turn; and of the further fields. */
    int first_above, first_below, first_azimuths, above, below, azimuths;
    /* Fields that are computed; the rest is a geometric series. */
    int orders;
} OrdersPlan;

/* The plan of the quality whose field of order 1 has this degree: 8, 10 or 14; NULL if there is none. */
const OrdersPlan *orders_plan(int first_degree);

/* The columns are even in asinh((middle - chord) * closeness), from `left` to `right`, where the chord is
 * that of the angle from the zenith, sqrt(2 - 2 sine): it is as smooth as the angle. They are closest where
 * the sun is 3 degrees below the horizon, and lie from -20 degrees to the zenith. */
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

/* The weights of scattering by aerosols, by degree, from 0 to first_degree. */
void orders_weights(const Atmosphere *atmosphere, const OrdersPlan *plan,
                    double weights[ORDERS_MOST_DEGREE + 1]);
