#include "view/day.h"

#include "base/vec3.h"
#include "scene/sun_clock.h"

#include <math.h>

static const double usual_noon_deg = 60, dark_deg = -18;

/* The real day is looked through in steps of ten minutes. */
static const double step_s = 600, day_s = 86400;

/* At latitude 90 - noon and with the sun on the equator, sin elevation = sin noon cos hour. */
static double hour_of(const Day *day, double elevation_deg) {
    double cosine = sin(elevation_deg * degree) / sin(day->noon_deg * degree);
    return acos(fmin(fmax(cosine, -1), 1)) * 12 / pi;
}

static double azimuth_from_noon(const Day *day) {
    double hour = day->hour * pi / 12;
    return atan2(sin(hour), cos(hour) * cos(day->noon_deg * degree)) / degree;
}

static bool is_dark(const Day *day, double utc_s) {
    Place place = sun_clock_place(&day->clock);
    return almanac_sun(utc_s, &place).elevation_deg < dark_deg;
}

Day day_of(const SceneValues *values) {
    Day day = {.clock = values->clock,
               .noon_deg = fmax(usual_noon_deg, fmin(fabs(values->sun.elevation_deg), 89.9))};
    day.hour = -hour_of(&day, values->sun.elevation_deg);
    day.noon_azimuth_deg = values->sun.azimuth_deg - azimuth_from_noon(&day);
    return day;
}

static void advance_clock(Day *day, double hours) {
    double before = day->clock.utc_s, now = before + 3600 * hours;
    if (is_dark(day, now) && !is_dark(day, before)) {
        double morning = now;
        while (is_dark(day, morning) && morning < now + day_s) morning += step_s;
        if (morning < now + day_s) now = morning;
    }
    day->clock.utc_s = now;
}

void day_advance(Day *day, double hours) {
    if (sun_clock_runs(&day->clock)) {
        advance_clock(day, hours);
        return;
    }
    double dark = hour_of(day, dark_deg);
    day->hour += hours;
    if (day->hour > dark && day->hour - hours <= dark) day->hour = -dark;
    if (day->hour > 12) day->hour -= 24;
}

static double clock_length(const Day *day) {
    double light = 0;
    for (double s = 0; s < day_s; s += step_s) light += is_dark(day, day->clock.utc_s + s) ? 0 : step_s;
    return (light > 0 ? light : day_s) / 3600;
}

double day_length(const Day *day) {
    return sun_clock_runs(&day->clock) ? clock_length(day) : 2 * hour_of(day, dark_deg);
}

void day_apply(const Day *day, SceneValues *values) {
    if (sun_clock_runs(&day->clock)) {
        values->clock = day->clock;
        sun_clock_set_utc(values, day->clock.utc_s);
        return;
    }
    double azimuth = day->noon_azimuth_deg + azimuth_from_noon(day);
    double elevation = asin(sin(day->noon_deg * degree) * cos(day->hour * pi / 12)) / degree;
    values->sun = sun_at(elevation, azimuth - 360 * floor(azimuth / 360), values->sun.radius_deg);
}
