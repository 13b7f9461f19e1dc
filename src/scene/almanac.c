#include "scene/almanac.h"

#include <erfa.h>
#include <math.h>
#include <stddef.h>

static const double unix_epoch_jd = 2440587.5, day_s = 86400;
static const double degrees = 57.295779513082320876798154814105;

const char *almanac_missing(void) {
    return NULL;
}

SunPlace almanac_sun(double utc_s, const Place *place) {
    eraASTROM astrom;
    double days = floor(utc_s / day_s), origins, sun[3], apparent[3], intermediate[3], right_ascension,
           declination;
    double azimuth, zenith, hour_angle, observed_declination, observed_right_ascension;
    /* It warns of years whose leap seconds are not known yet. They would turn the sky by 0.004 degrees each.
     */
    (void)eraApco13(unix_epoch_jd + days, utc_s / day_s - days, 0, place->longitude_deg / degrees,
                    place->latitude_deg / degrees, place->height_m, 0, 0, 0, 0, 0, 0.55, &astrom, &origins);
    /* The sun is where the observer is not: `eh` leads from the sun to the observer. Light takes eight
     * minutes, in which the sun moves by 0.01 seconds of arc. */
    for (int i = 0; i < 3; i++) sun[i] = -astrom.eh[i];
    eraAb(sun, astrom.v, astrom.em, astrom.bm1, apparent);
    eraRxp(astrom.bpn, apparent, intermediate);
    eraC2s(intermediate, &right_ascension, &declination);
    eraAtioq(eraAnp(right_ascension), declination, &astrom, &azimuth, &zenith, &hour_angle,
             &observed_declination, &observed_right_ascension);
    return (SunPlace){90 - zenith * degrees, azimuth * degrees};
}
