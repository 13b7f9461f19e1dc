/* Fields of light on the CPU's grid: their moments, which are integrals over the sphere of the radiance times
 * the harmonics about the sun's direction (sky/harmonics.h), and the ground's irradiance by them. */
#pragma once

#include "sky/orders_air.h"
#include "sky/orders_grid.h"

typedef struct OrdersField {
    /* Of the harmonics. */
    int degree;
    /* [row][column][harmonic][channel] and [column][channel], owned. */
    double *moments, *ground;
} OrdersField;

/* A dark field with harmonics up to a degree. */
OrdersField orders_field_create(const OrdersGrid *grid, int most);
void orders_field_free(OrdersField *field);

/* The moments of a point. */
double *orders_field_at(const OrdersGrid *grid, const OrdersField *field, int row, int column);

/* Adds a field to a sum whose degree is not lower. With `before`, the field of the order before, it stands
 * for itself and `further` more (INFINITY for all): a geometric series. */
void orders_field_add(const OrdersGrid *grid, OrdersField *sum, const OrdersField *field,
                      const OrdersField *before, double further);

/* A copy for lookups, of harmonics up to the degree `most`: in place of moment 0 its logarithm, in place of
 * the others their quotients by moment 0, and the ground's logarithm. Light has many orders of magnitude, and
 * so can be interpolated. */
OrdersField orders_field_pack(const OrdersGrid *grid, const OrdersField *field, int most);

/* What stays the same along a ray whose cosine to the sun is `nu`. */
typedef struct OrdersAim {
    int degree;
    double nu;
    /* The harmonics at azimuth 0 times the weights of scattering: by air (0,0), (0,2), (1,2), (2,2), and by
     * aerosols. */
    double air[4], aerosol[HARMONICS_MOST];
    /* Where the moments (0,2), (1,2) and (2,2) are. */
    int second[3];
} OrdersAim;

void orders_aim(const OrdersAir *air, const HarmonicStep *steps, int most, double nu, OrdersAim *aim);

/* The packed moments of a point and their weight in an interpolation. */
typedef struct OrdersCorner {
    const double *moments;
    double weight;
} OrdersCorner;

/* The light that a node of a ray scatters along it. `rise` and `sun_rise` are the ray's and the sun's at its
 * origin. */
void orders_scatter(const OrdersAim *aim, const OrdersCorner *corners, int count, double rise,
                    double sun_rise, const OrdersNode *node, double radiance[3]);

/* Adds the light of the ground at a ray's end, where a packed field lights it. */
void orders_field_ground(const OrdersGrid *grid, const OrdersField *packed, const OrdersAir *air,
                         const OrdersRay *ray, double sun_rise, double nu, double radiance[3]);
