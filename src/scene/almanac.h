/* Where the sun stands at a place on the Earth at a moment, by the library ERFA (the International
 * Astronomical Union's routines, as free software). It is an option of the build: without it all functions
 * say so. */
#pragma once

#include "base/error.h"

typedef struct Place {
    /* North and east are positive. */
    double latitude_deg, longitude_deg, height_m;
} Place;

/* The sun's middle, seen from that place. The azimuth is counted from true north through east, from 0 to 360.
 *
 * Refraction by the air is left out, as it is in pictures. Precession, nutation, aberration and parallax are
 * in. The difference of UT1 and UTC, which is less than a second and not known beforehand, is left out: it
 * turns the sky by less than 0.004 degrees. */
typedef struct SunPlace {
    double elevation_deg, azimuth_deg;
} SunPlace;

/* NULL if this build has an almanac, else what is missing and how to get it. */
const char *almanac_missing(void);

/* `utc_s` are seconds since 1970-01-01T00:00Z, without leap seconds. */
SunPlace almanac_sun(double utc_s, const Place *place);
