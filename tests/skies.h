/* Skies with all orders of scattering by another program (tests/data), errors in classes by the sun's
 * elevation, and the balance of the light that enters and leaves an air which absorbs nothing. */
#pragma once

#include "scene/atmosphere.h"

#include <stdbool.h>

enum { SKIES_MOST_ROWS = 400, SKIES_AIRS = 6 };

typedef struct SkiesRow {
    /* The azimuth is the view's less the sun's. Rows of irradiance have no view. */
    double height_m, sun_deg, view_deg, azimuth_deg;
    /* The number of its air. */
    int air;
    double total[3], single[3];
} SkiesRow;

/* Radiances, and irradiances of level ground by the sky. Both return the number of rows. */
int skies_radiances(SkiesRow rows[SKIES_MOST_ROWS]);
int skies_irradiances(SkiesRow rows[SKIES_MOST_ROWS]);

/* The airs of the rows, with all orders: the ground's albedo is 0, 0.3 or 0.8, and there is ozone from 3 on.
 */
Atmosphere skies_air(int number);

/* The sun's azimuth is 0, toward +z. */
void skies_direction(double elevation_deg, double azimuth_deg, double out[3]);

/* By day the sun stands at 5 degrees or higher; twilight goes down to -6. */
typedef enum SkiesClass { SKIES_DAY, SKIES_LOW, SKIES_TWILIGHT, SKIES_DEEP, SKIES_CLASSES } SkiesClass;

typedef struct SkiesErrors {
    /* Relative, in percent. */
    double errors[SKIES_CLASSES][3 * SKIES_MOST_ROWS];
    int counts[SKIES_CLASSES];
} SkiesErrors;

/* Adds the errors of three channels. */
void skies_errors_add(SkiesErrors *errors, double sun_deg, const double got[3], const double expected[3]);

/* The RMS and the 99th percentile, in percent. */
typedef struct SkiesBounds {
    double rms, p99;
} SkiesBounds;

/* Prints the errors, and fails the test where they are past the bounds. */
void skies_errors_expect(SkiesErrors *errors, const char *name, const SkiesBounds bounds[SKIES_CLASSES]);

/* Directions of the upper half of the sphere. The sum of radiances times weights is the irradiance of level
 * ground. */
enum { SKIES_DOME = 24 * 16 };
typedef struct SkiesDome {
    double directions[SKIES_DOME][3], weights[SKIES_DOME];
} SkiesDome;
void skies_dome(SkiesDome *dome);

/* Radiances for an observer at the top of the air, of all orders. */
typedef void SkiesAsk(void *state, double sun_deg, const double (*directions)[3], int count,
                      double (*radiances)[3]);

/* The light that leaves the air through its top, as a share of the sunlight that enters it. It is 1 if the
 * air and the ground absorb nothing. */
void skies_balance(const Atmosphere *atmosphere, SkiesAsk *ask, void *state, double shares[3]);
