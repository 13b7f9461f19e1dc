#include "sky/air_column.h"

#include "base/vec3.h"

#include <math.h>

/* exp(y^2) erfc(y) for y >= 0. */
static double scaled_erfc(double y) {
    if (y < 8) return exp(y * y) * erfc(y);
    double q = 1 / (2 * y * y);
    return (1 - q * (1 - 3 * q * (1 - 5 * q * (1 - 7 * q)))) / (y * sqrt(pi));
}

/* The column above a point at distance r, divided by the density there, of a layer that thins by e over
 * `scale`. See glsl/sky/column.glsl for the formula. Where y is large, its terms cancel, and the first terms
 * of their series are taken. */
static double exponential_length(double scale, double r, double cosine) {
    double x = r / scale, y = sqrt(x / 2) * cosine, scaled = scaled_erfc(y), y2 = y * y;
    double second = y < 8 ? 0.375 - y2 / 2 + y2 * y2 / 2 + 2 * y * (0.375 - y2 / 4) / (sqrt(pi) * scaled)
                          : 1 - (1 - 3.1 / y2) / y2;
    return scale * sqrt(pi * x / 2) * scaled * (1 + second / x);
}

/* The column of a layer above a point. The cosine is not negative. */
static double exponential_above(double scale, double height, double r, double cosine) {
    return exp(-height / scale) * exponential_length(scale, r, cosine);
}

/* The integral of sqrt(r^2 + 2 rise t + t^2) - R from `from` to `to`, where `p` is the perigee's distance. */
static double altitude_integral(double planet_radius, double p, double from, double to) {
    double a = hypot(p, from), b = hypot(p, to);
    double arc = p > 0 ? p * p * (asinh(to / p) - asinh(from / p)) : 0;
    return (to * b - from * a + arc) / 2 - planet_radius * (to - from);
}

/* The ozone's column along an ascending ray: in each half of the layer the density is linear in the altitude.
 */
static double ozone_above(const Atmosphere *a, double height, double rise) {
    double radius = a->planet_radius_m + height, p = sqrt(fmax(0, (radius - rise) * (radius + rise)));
    double top = air_top_height(a), middle = a->ozone_height_m, half = a->ozone_half_width_m;
    double cuts[3] = {middle - half, middle, middle + half}, column = 0;
    for (int i = 0; i < 2; i++) {
        double low = fmin(fmax(cuts[i], height), top), high = fmin(fmax(cuts[i + 1], height), top);
        if (high <= low) continue;
        double from = rise + air_distance_out(rise, air_square_above(a, low, height));
        double to = rise + air_distance_out(rise, air_square_above(a, high, height));
        double altitudes = altitude_integral(a->planet_radius_m, p, from, to);
        column += (i ? 1 : -1) * (cuts[2 * i] * (to - from) - altitudes) / half;
    }
    return fmax(column, 0);
}

static AirColumns ascending(const Atmosphere *a, double height, double rise) {
    AirColumns columns = {0};
    double r = a->planet_radius_m + height, top = air_top_height(a), cosine = fmin(rise / r, 1);
    double rise_at_top = sqrt(fmax(0, rise * rise + air_square_above(a, top, height)));
    double cosine_at_top = fmin(rise_at_top / a->top_radius_m, 1);
    if (height >= top) return columns;
    if (a->rayleigh > 0) {
        double scale = a->rayleigh_scale_height_m;
        columns.air = a->rayleigh * (exponential_above(scale, height, r, cosine) -
                                     exponential_above(scale, top, a->top_radius_m, cosine_at_top));
    }
    if (a->mie > 0) {
        double scale = a->mie_scale_height_m;
        columns.aerosol = a->mie * (exponential_above(scale, height, r, cosine) -
                                    exponential_above(scale, top, a->top_radius_m, cosine_at_top));
    }
    if (a->ozone > 0) columns.ozone = a->ozone * ozone_above(a, height, rise);
    return columns;
}

AirColumns air_column_to_top(const Atmosphere *a, double height, double rise) {
    AirColumns up = ascending(a, height, fabs(rise));
    if (rise >= 0) return up;
    AirColumns level = ascending(a, air_perigee_altitude(a, height, rise), 0);
    return (AirColumns){fmax(0, 2 * level.air - up.air), fmax(0, 2 * level.aerosol - up.aerosol),
                        fmax(0, 2 * level.ozone - up.ozone)};
}
