/* An air as the CPU's solver of the further orders sees it (sky/sky_orders.h): what it scatters by degree,
 * and the quadrature along rays. */
#pragma once

#include "sky/air_path.h"
#include "sky/gauss_table.h"
#include "sky/harmonics.h"

enum { ORDERS_MOST_RAY_NODES = 160 };

typedef struct OrdersAir {
    Atmosphere atmosphere;
    /* The share of the aerosols' extinction that counts on the way to the eye. It is below 1 if a part of
     * their scattering, the peak, is taken as not scattered at all. */
    double kept;
    /* The weights of the aerosols' scattering by degree: Legendre coefficients less the peak. */
    double weights[HARMONICS_MOST_DEGREE + 1];
} OrdersAir;

/* The weights are those up to the degree `most`. With `peak`, the peak is the Legendre coefficient three
 * degrees above `most`, or 0 if g is below 0. */
OrdersAir orders_air(const Atmosphere *atmosphere, int most, bool peak);

/* A Gauss quadrature on (0,1). */
typedef struct OrdersGauss {
    int count;
    double nodes[GAUSS_MOST_NODES], weights[GAUSS_MOST_NODES];
} OrdersGauss;

OrdersGauss orders_gauss(int count);

typedef struct OrdersNode {
    /* The distance from the ray's origin, the altitude, and the distance from the planet's centre. */
    double t, height, radius;
    /* The length that the node stands for, times scattering per metre, times the transmittance to the origin.
     */
    double air[3], aerosol[3];
} OrdersNode;

typedef struct OrdersRay {
    /* The part within the air; its origin is `start` from the ray's. */
    AirPath path;
    double start;
    OrdersNode nodes[ORDERS_MOST_RAY_NODES];
    int count;
    /* The transmittance to the ground; 0 if the ray does not end there. */
    double ground[3];
} OrdersRay;

/* The nodes along a ray from an altitude with the cosine to the zenith, by a quadrature on each of its parts.
 * It is cut at its perigee and at the `cuts`, which are distances from its origin in any order. */
void orders_ray(const OrdersAir *air, double height, double cosine, const OrdersGauss *gauss,
                const double *cuts, int cut_count, OrdersRay *ray);

/* The irradiance of level ground by the sun alone, whose irradiance is 1 and whose elevation has this sine.
 */
void orders_air_sunlight(const OrdersAir *air, double sine, double irradiance[3]);

/* The radiance of light that was scattered once, by the air or the ground, for a sun of irradiance 1. `mu`
 * and `mu_sun` are the sines of elevation of the direction and of the sun, `nu` is the cosine between the
 * two. */
void orders_air_first(const OrdersAir *air, double height, double mu, double mu_sun, double nu,
                      const OrdersGauss *gauss, double radiance[3]);
