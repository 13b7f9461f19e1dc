#include "sky/air_path.h"

#include <math.h>

enum { GAUSS_PAIRS = 8 };

/* Gauss-Legendre quadrature with 16 nodes: the positive half of the nodes. */
static const double gauss_node[GAUSS_PAIRS] = {
    0.0950125098376374402, 0.281603550779258913, 0.458016777657227386, 0.617876244402643748,
    0.755404408355003034,  0.865631202387831744, 0.944575023073232576, 0.989400934991649933};
static const double gauss_weight[GAUSS_PAIRS] = {
    0.189450610455068496, 0.182603415044923589,  0.169156519395002538,  0.149595988816576732,
    0.124628971255533872, 0.0951585116824927848, 0.0622535239386478929, 0.0271524594117540949};

typedef double Density(const Atmosphere *atmosphere, double height);

double air_molecule_density(const Atmosphere *atmosphere, double height) {
    return atmosphere->rayleigh * exp(-height / atmosphere->rayleigh_scale_height_m);
}

double air_aerosol_density(const Atmosphere *atmosphere, double height) {
    return atmosphere->mie * exp(-height / atmosphere->mie_scale_height_m);
}

double air_ozone_density(const Atmosphere *atmosphere, double height) {
    double off = fabs(height - atmosphere->ozone_height_m) / atmosphere->ozone_half_width_m;
    return atmosphere->ozone * fmax(0, 1 - off);
}

double air_extinction(const Atmosphere *atmosphere, const AirColumns *columns, int c) {
    return atmosphere->rayleigh_scatter_per_m[c] * columns->air +
           atmosphere->mie_extinction_ratio * atmosphere->mie_scatter_per_m[c] * columns->aerosol +
           atmosphere->ozone_absorb_per_m[c] * columns->ozone;
}

double air_top_height(const Atmosphere *atmosphere) {
    return atmosphere->top_radius_m - atmosphere->planet_radius_m;
}

double air_square_above(const Atmosphere *atmosphere, double height, double altitude) {
    return (height - altitude) * (2 * atmosphere->planet_radius_m + height + altitude);
}

double air_altitude_along(double height, double radius, double rise, double t) {
    double gained = t * (2 * rise + t);
    return height + gained / (sqrt(fmax(0, radius * radius + gained)) + radius);
}

double air_perigee_altitude(const Atmosphere *atmosphere, double height, double rise) {
    double radius = atmosphere->planet_radius_m;
    double above = air_square_above(atmosphere, height, 0) - rise * rise;
    return above / (radius + sqrt(fmax(0, radius * radius + above)));
}

double air_distance_out(double rise, double square) {
    double root = sqrt(fmax(0, rise * rise + square));
    if (rise <= 0) return root - rise;
    return fmax(0, square) / (rise + root);
}

/* Integrates from a leg's low end upward, where density falls. Beside the exponential the integrand has the
 * singularities of the altitude, at the complex distances -radius exp(+-i angle). So panels longer than a
 * radius are cut by doubling. */
static double leg_integral(const Atmosphere *atmosphere, const AirPath *leg, double from, double to,
                           Density *density) {
    double sum = 0;
    while (from < to) {
        double end = fmin(to, from + fmax(from, leg->radius)), half = (end - from) / 2, part = 0;
        for (int i = 0; i < 2 * GAUSS_PAIRS; i++) {
            double t = from + half * (1 + (i % 2 ? 1 : -1) * gauss_node[i / 2]);
            double height = air_altitude_along(leg->height, leg->radius, leg->rise, t);
            part += gauss_weight[i / 2] * density(atmosphere, height);
        }
        sum += half * part;
        from = end;
    }
    return sum;
}

/* The leg is cut at three altitudes in rising order. Nothing above the third is counted. */
static double leg_column(const Atmosphere *atmosphere, const AirPath *leg, const double altitudes[3],
                         Density *density) {
    double sum = 0, from = 0;
    for (int i = 0; i < 3; i++) {
        double gain = fmax(0, altitudes[i] - leg->height);
        double to = fmin(leg->length, air_distance_out(leg->rise, gain * (2 * leg->radius + gain)));
        sum += leg_integral(atmosphere, leg, from, to, density);
        from = to;
    }
    return sum;
}

/* 16 nodes over 16 scale heights integrate a column to 1e-13, both for a steep leg (an exponential) and for a
 * leg from its perigee (a Gaussian). Past 48 scale heights at most exp(-48) of the column is left. */
static double exponential_column(const Atmosphere *atmosphere, const AirPath *leg, double scale,
                                 Density *density) {
    double low = leg->height, altitudes[3] = {low + 16 * scale, low + 32 * scale, low + 48 * scale};
    return leg_column(atmosphere, leg, altitudes, density);
}

static void add_leg(const Atmosphere *atmosphere, const AirPath *leg, AirColumns *columns) {
    double middle = atmosphere->ozone_height_m, half = atmosphere->ozone_half_width_m;
    double tent[3] = {middle - half, middle, middle + half};
    double air = atmosphere->rayleigh_scale_height_m, aerosol = atmosphere->mie_scale_height_m;
    if (atmosphere->rayleigh > 0)
        columns->air += exponential_column(atmosphere, leg, air, air_molecule_density);
    if (atmosphere->mie > 0)
        columns->aerosol += exponential_column(atmosphere, leg, aerosol, air_aerosol_density);
    if (atmosphere->ozone > 0) columns->ozone += leg_column(atmosphere, leg, tent, air_ozone_density);
}

/* The line is cut at its perigee into legs that rise. */
AirColumns air_columns(const Atmosphere *atmosphere, double height, double rise, double length) {
    AirColumns columns = {0};
    bool has_perigee = rise < 0 && -rise < length;
    AirPath leg = {.height = height, .rise = rise, .length = length};
    if (has_perigee) {
        leg = (AirPath){.height = air_perigee_altitude(atmosphere, height, rise), .length = -rise};
    } else if (rise < 0) {
        leg.height = air_altitude_along(height, atmosphere->planet_radius_m + height, rise, length);
        leg.rise = -rise - length;
    }
    leg.radius = atmosphere->planet_radius_m + leg.height;
    add_leg(atmosphere, &leg, &columns);
    if (has_perigee) {
        leg.length = length + rise;
        add_leg(atmosphere, &leg, &columns);
    }
    return columns;
}

bool air_path_clip(const Atmosphere *atmosphere, double height, double cosine, AirPath *path, double *start) {
    double top = air_top_height(atmosphere), radius = atmosphere->planet_radius_m + height;
    *path = (AirPath){height, radius, radius * cosine, 0, false};
    *start = 0;
    if (height > top) {
        double square = air_square_above(atmosphere, height, top), chord = path->rise * path->rise - square;
        if (path->rise >= 0 || chord <= 0) return false;
        *start = square / (sqrt(chord) - path->rise);
        *path = (AirPath){top, atmosphere->top_radius_m, -sqrt(chord), 0, false};
    }
    double square = air_square_above(atmosphere, path->height, 0), chord = path->rise * path->rise - square;
    path->ground = path->rise < 0 && chord > 0;
    path->length = path->ground
                       ? square / (sqrt(chord) - path->rise)
                       : air_distance_out(path->rise, air_square_above(atmosphere, top, path->height));
    return path->length > 0;
}
