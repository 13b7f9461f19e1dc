#include "scene/almanac.h"

const char *almanac_missing(void) {
    return "this build has no almanac, without which nobody knows where the sun stands; build it without "
           "ALMANAC=0, or name the sun's elevation and azimuth";
}

SunPlace almanac_sun(double utc_s, const Place *place) {
    (void)utc_s;
    (void)place;
    return (SunPlace){0};
}
