/* How finely the orders of scattering beyond the first are computed on the GPU, and what follows from the air
 * and that alone (glsl/sky/README.md). */
#pragma once

#include "scene/atmosphere.h"

enum { ORDER_FIELDS = 5, ORDERS_MOST_ELEVATIONS = 32, ORDERS_MOST_DEGREE = 24 };

/* The field of light of one order. */
typedef struct OrderPlan {
    /* The highest degree of its harmonics, ORDERS_MOST_DEGREE at most. */
    int degree;
    /* The directions in which it is computed: elevations above and below the horizon, of which there are
     * ORDERS_MOST_ELEVATIONS at most, and azimuths in half a turn. The other half is its mirror image. */
    int above, below, azimuths;
} OrderPlan;

typedef struct OrdersPlan {
    /* The grid of points: elevations of the sun across, altitudes along. */
    int columns, rows;
    /* The fields that are computed. Those that follow are taken as a geometric series. No degree is above
     * that of the field before. */
    OrderPlan orders[ORDER_FIELDS];
} OrdersPlan;

/* The plan of the quality whose field of order 1 has this degree: 8, 10 or 14; NULL if there is none. */
const OrdersPlan *orders_plan(int degree);

/* The number of all directions in which a field is computed. */
int order_directions(const OrderPlan *order);

/* The grid's columns are even in asinh((middle - chord) * closeness), from `left` to `right`. The chord is
 * that of the sun's angle from the zenith, sqrt(2 - 2 sine). It is as smooth as the angle, and shaders can
 * compute it without arc functions. Columns lie from -20 degrees to the zenith, and are closest where the sun
 * is 3 degrees below the horizon: light changes most there. */
typedef struct OrdersColumns {
    double middle, closeness, left, right;
} OrdersColumns;

OrdersColumns orders_columns(void);

/* The share of the light scattered by aerosols that counts as not scattered at all, because it goes on nearly
 * straight. It stands for the harmonics beyond the degree of order 1: a phase function that is cut off at
 * some degree lacks its peak (delta scaling, Joseph, Wiscombe and Weinman 1976). It is from 0 to 1, and 0 for
 * an air of one order. */
double orders_peak(const Atmosphere *atmosphere, const OrdersPlan *plan);

/* The share of the aerosols' extinction that is left on the way to the eye if that light is not lost. It is 1
 * for an air of one order. On the way from the sun all extinction counts. */
double orders_kept(const Atmosphere *atmosphere, const OrdersPlan *plan);

/* The weights of scattering by aerosols, by degree: the Legendre coefficients of the phase function less the
 * peak's share, which is the same for all degrees. They are 0 beyond the degree of order 1. */
void orders_weights(const Atmosphere *atmosphere, const OrdersPlan *plan,
                    double weights[ORDERS_MOST_DEGREE + 1]);
