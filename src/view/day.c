#include "view/day.h"

#include "base/vec3.h"

#include <math.h>
static const double usual_noon_deg = 60, dark_deg = -18;

/* At latitude 90 - noon and with the sun on the equator, sin elevation = sin noon cos hour. */
static double hour_of(const Day *day, double elevation_deg) {
    double cosine = sin(elevation_deg * degree) / sin(day->noon_deg * degree);
    return acos(fmin(fmax(cosine, -1), 1)) * 12 / pi;
}

static double azimuth_from_noon(const Day *day) {
    double hour = day->hour * pi / 12;
    return atan2(sin(hour), cos(hour) * cos(day->noon_deg * degree)) / degree;
}

Day day_through(double elevation_deg, double azimuth_deg) {
    Day day = {.noon_deg = fmax(usual_noon_deg, fmin(fabs(elevation_deg), 89.9))};
    day.hour = -hour_of(&day, elevation_deg);
    day.noon_azimuth_deg = azimuth_deg - azimuth_from_noon(&day);
    return day;
}

void day_advance(Day *day, double hours) {
    double dark = hour_of(day, dark_deg);
    day->hour += hours;
    if (day->hour > dark && day->hour - hours <= dark) day->hour = -dark;
    if (day->hour > 12) day->hour -= 24;
}

double day_length(const Day *day) {
    return 2 * hour_of(day, dark_deg);
}

void day_sun(const Day *day, double *elevation_deg, double *azimuth_deg) {
    double azimuth = day->noon_azimuth_deg + azimuth_from_noon(day);
    *elevation_deg = asin(sin(day->noon_deg * degree) * cos(day->hour * pi / 12)) / degree;
    *azimuth_deg = azimuth - 360 * floor(azimuth / 360);
}
