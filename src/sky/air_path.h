/* Straight paths through the air, in double precision on the CPU: where they enter and end, and how much air
 * lies along them.
 *
 * A ray is held as three numbers: the altitude of its origin, the origin's distance from the planet's centre
 * ("radius"), and "rise", which is the radius times the cosine of the zenith angle. Rise is the origin's
 * position along the ray, measured from the ray's perigee, its point nearest to the centre. All altitudes are
 * computed from differences of squares written as products, never as |p| - R, which would lose seven digits.
 * So double is precise enough, and rounding stays near 1e-9 m. */
#pragma once

#include "scene/atmosphere.h"

#include <stdbool.h>

typedef struct AirPath {
    /* These are the origin's. */
    double height, radius, rise;
    double length;
    /* Whether the path ends at the ground. */
    bool ground;
} AirPath;

/* Density times length, in metres at density 1. */
typedef struct AirColumns {
    double air, aerosol, ozone;
} AirColumns;

/* Densities at a height, relative to the unit of each layer. */
double air_molecule_density(const Atmosphere *atmosphere, double height);
double air_aerosol_density(const Atmosphere *atmosphere, double height);
double air_ozone_density(const Atmosphere *atmosphere, double height);

/* Returns the optical depth of the columns in a colour channel. */
double air_extinction(const Atmosphere *atmosphere, const AirColumns *columns, int c);

double air_top_height(const Atmosphere *atmosphere);

/* Returns the squared distance from the centre, minus that of a point at `altitude`. */
double air_square_above(const Atmosphere *atmosphere, double height, double altitude);

/* Returns the altitude at the distance t from the origin. */
double air_altitude_along(double height, double radius, double rise, double t);
double air_perigee_altitude(const Atmosphere *atmosphere, double height, double rise);

/* Returns the distance to the far intersection with a sphere. `square` is the sphere's squared radius minus
 * the origin's, as from air_square_above(). */
double air_distance_out(double rise, double square);

/* Returns the columns along a straight line within the atmosphere. */
AirColumns air_columns(const Atmosphere *atmosphere, double height, double rise, double length);

/* Sets `path` to the part of a ray within the atmosphere, from `*start` on. Returns false if there is none.
 */
bool air_path_clip(const Atmosphere *atmosphere, double height, double cosine, AirPath *path, double *start);
