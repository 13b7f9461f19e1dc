#include "sky/orders_field.h"

#include "base/memory.h"
#include "base/vec3.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Light below this counts as none, for a sun of irradiance 1. Its logarithm is near enough to that of the
 * darkest light for the cubic interpolation between the two. */
static const double dark = 1e-30;

/* The most that the ratio of successive orders may be where a series is summed. Early orders still spread
 * into the shadow, so that their ratio there is above that of the late ones. In thick air without absorption
 * the true one nears 1. */
static const double most_ratio = 0.9;

static size_t points(const OrdersGrid *grid) {
    return (size_t)grid->rows * (size_t)grid->columns;
}

static size_t stride(int most) {
    return 3 * (size_t)harmonics_count(most);
}

OrdersField orders_field_create(const OrdersGrid *grid, int most) {
    return (OrdersField){.degree = most,
                         .moments = memory_get(points(grid) * stride(most), sizeof(double)),
                         .ground = memory_get(3 * (size_t)grid->columns, sizeof(double))};
}

void orders_field_free(OrdersField *field) {
    free(field->moments);
    free(field->ground);
    *field = (OrdersField){0};
}

double *orders_field_at(const OrdersGrid *grid, const OrdersField *field, int row, int column) {
    return field->moments + ((size_t)row * (size_t)grid->columns + (size_t)column) * stride(field->degree);
}

/* 1 + r + r^2 + ..., where r is the ratio of this order to the one before. */
static double series(double value, double before, double further) {
    double ratio = before > 0 ? fmin(value / before, most_ratio) : 0;
    return (1 - (isinf(further) ? 0 : pow(ratio, further + 1))) / (1 - ratio);
}

void orders_field_add(const OrdersGrid *grid, OrdersField *sum, const OrdersField *field,
                      const OrdersField *before, double further) {
    for (size_t p = 0; p < points(grid); p++) {
        const double *from = field->moments + p * stride(field->degree);
        double *to = sum->moments + p * stride(sum->degree), factor[3] = {1, 1, 1};
        for (int c = 0; before && c < 3; c++)
            factor[c] = series(from[c], before->moments[p * stride(before->degree) + (size_t)c], further);
        for (int m = 0, k = 0; m <= field->degree; m++) {
            for (int l = m; l <= field->degree; l++, k++) {
                int at = harmonics_index(sum->degree, l, m);
                for (int c = 0; c < 3; c++) to[3 * at + c] += factor[c] * from[3 * k + c];
            }
        }
    }
    for (int i = 0; i < 3 * grid->columns; i++)
        sum->ground[i] +=
            field->ground[i] * (before ? series(field->ground[i], before->ground[i], further) : 1);
}

OrdersField orders_field_pack(const OrdersGrid *grid, const OrdersField *field, int most) {
    OrdersField packed = orders_field_create(grid, most);
    for (size_t p = 0; p < points(grid); p++) {
        const double *from = field->moments + p * stride(field->degree);
        double *to = packed.moments + p * stride(most);
        for (int c = 0; c < 3; c++) to[c] = log(fmax(from[c], dark));
        for (int m = 0, k = 0; m <= most; m++) {
            for (int l = m; l <= most; l++, k++) {
                int at = harmonics_index(field->degree, l, m);
                for (int c = 0; k && c < 3; c++)
                    to[3 * k + c] = from[c] > dark ? from[3 * at + c] / from[c] : 0;
            }
        }
    }
    for (int i = 0; i < 3 * grid->columns; i++) packed.ground[i] = log(fmax(field->ground[i], dark));
    return packed;
}

void orders_aim(const OrdersAir *air, const HarmonicStep *steps, int most, double nu, OrdersAim *aim) {
    /* Rayleigh's weights of the degrees 0 and 2; all others are 0. */
    static const double whole = 1, second = 0.1;
    aim->degree = most;
    aim->nu = nu;
    harmonics_at(steps, most, nu, 1, aim->aerosol);
    aim->air[0] = whole * aim->aerosol[0];
    for (int m = 0; m <= 2; m++) {
        aim->second[m] = harmonics_index(most, 2, m);
        aim->air[1 + m] = second * aim->aerosol[aim->second[m]];
    }
    for (int m = 0, k = 0; m <= most; m++) {
        for (int l = m; l <= most; l++, k++) aim->aerosol[k] *= air->weights[l];
    }
}

/* Adds a corner's part of the light, relative to moment 0, by air and by aerosols. `cosines` are those of
 * multiples of the azimuth. */
static void add_corner(const OrdersAim *aim, const OrdersCorner *corner, const double *cosines,
                       double by_air[3], double by_aerosol[3]) {
    int most = aim->degree;
    const double *at = corner->moments;
    for (int c = 0; c < 3; c++) {
        by_air[c] += corner->weight * aim->air[0];
        by_aerosol[c] += corner->weight * aim->aerosol[0];
        for (int m = 0; m <= 2; m++)
            by_air[c] += corner->weight * cosines[m] * aim->air[1 + m] * at[3 * aim->second[m] + c];
    }
    /* Moment 0 is done. */
    for (int m = 0, k = 1; m <= most; m++) {
        double sum[3] = {0}, factor = corner->weight * cosines[m];
        for (int l = m ? m : 1; l <= most; l++, k++) {
            for (int c = 0; c < 3; c++) sum[c] += aim->aerosol[k] * at[3 * k + c];
        }
        for (int c = 0; c < 3; c++) by_aerosol[c] += factor * sum[c];
    }
}

void orders_scatter(const OrdersAim *aim, const OrdersCorner *corners, int count, double rise,
                    double sun_rise, const OrdersNode *node, double radiance[3]) {
    double by_air[3] = {0}, by_aerosol[3] = {0}, whole[3] = {0}, cosines[HARMONICS_MOST_DEGREE + 1];
    double mu = (rise + node->t) / node->radius, mu_sun = (sun_rise + aim->nu * node->t) / node->radius;
    double cosine = harmonics_azimuth(mu, mu_sun, aim->nu);
    cosines[0] = 1;
    cosines[1] = cosine;
    for (int m = 2; m <= aim->degree; m++) cosines[m] = 2 * cosine * cosines[m - 1] - cosines[m - 2];
    for (int i = 0; i < count; i++) {
        for (int c = 0; c < 3; c++) whole[c] += corners[i].weight * corners[i].moments[c];
        add_corner(aim, &corners[i], cosines, by_air, by_aerosol);
    }
    /* What is cut off of a series may leave it below 0 where hardly any light goes. */
    for (int c = 0; c < 3; c++) {
        double light = node->air[c] * by_air[c] + node->aerosol[c] * by_aerosol[c];
        radiance[c] += exp(whole[c]) * fmax(0, light);
    }
}

void orders_field_ground(const OrdersGrid *grid, const OrdersField *packed, const OrdersAir *air,
                         const OrdersRay *ray, double sun_rise, double nu, double radiance[3]) {
    const Atmosphere *a = &air->atmosphere;
    if (!ray->path.ground) return;
    OrdersPlace place = orders_grid_column(grid, (sun_rise + nu * ray->path.length) / a->planet_radius_m);
    for (int c = 0; c < 3; c++) {
        double sum = 0;
        for (int i = 0; i < grid->points; i++)
            sum += place.weights[i] * packed->ground[3 * (place.first + i) + c];
        radiance[c] += ray->ground[c] * a->ground_albedo[c] / pi * exp(sum);
    }
}
