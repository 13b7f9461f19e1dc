/* Straight ways through the air, in double on the CPU: where they enter and end, and how much air lies along
 * them.
 *
 * A ray is held as the altitude of its origin, the origin's distance from the planet's centre ("radius") and
 * "rise", radius times the cosine of the zenith angle: the origin's position along the ray, counted from the
 * ray's perigee. All altitudes follow from differences of squares written as products, never as |p| - R,
 * which would lose seven digits. So double is enough, and noise stays near 1e-9 m. */
#pragma once

#include "scene/atmosphere.h"

#include <stdbool.h>

typedef struct AirPath {
    /* Of the origin. */
    double height, radius, rise;
    double length;
    /* Whether the path ends on the ground. */
    bool ground;
} AirPath;

/* Density times length, in metres at density 1. */
typedef struct AirColumns {
    double air, aerosol, ozone;
} AirColumns;

/* Densities at a height, relative to the layer's own unit. */
double air_molecule_density(const Atmosphere *atmosphere, double height);
double air_aerosol_density(const Atmosphere *atmosphere, double height);
double air_ozone_density(const Atmosphere *atmosphere, double height);

/* Returns the optical depth of columns in a channel. */
double air_extinction(const Atmosphere *atmosphere, const AirColumns *columns, int c);

double air_top_height(const Atmosphere *atmosphere);

/* Returns the squared distance from the centre, less that of an altitude. */
double air_square_above(const Atmosphere *atmosphere, double height, double altitude);

/* Returns the altitude at the distance t from an origin. */
double air_altitude_along(double height, double radius, double rise, double t);
double air_perigee_altitude(const Atmosphere *atmosphere, double height, double rise);

/* Returns the distance to the far crossing of the sphere that lies `square` outside the origin's (as
 * air_square_above gives it). */
double air_distance_out(double rise, double square);

/* Returns the columns along a straight way within the atmosphere. */
AirColumns air_columns(const Atmosphere *atmosphere, double height, double rise, double length);

/* Sets `path` to the part of a ray within the atmosphere, from `*start` on. Returns false if there is none.
 */
bool air_path_clip(const Atmosphere *atmosphere, double height, double cosine, AirPath *path, double *start);
