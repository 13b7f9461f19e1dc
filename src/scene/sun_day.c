#include "scene/sun_day.h"

#include "base/vec3.h"

#include <math.h>

/* The sun is looked up so often, and between two of these moments it does one thing. */
enum { STEP_S = 300, DAY_S = 86400 };

const double sunrise_elevation_deg = -50.0 / 60;

static double elevation_at(const SunDay *day, double seconds) {
    return almanac_sun(day->midnight.utc_s + seconds, &day->place).elevation_deg;
}

SunDay sun_day(const Moment *moment, const Place *place) {
    SunDay day = {.midnight = moment_midnight(moment), .place = *place, .highest_deg = -90, .lowest_deg = 90};
    for (int s = 0; s <= DAY_S; s += STEP_S) {
        double elevation = elevation_at(&day, s);
        if (elevation > day.highest_deg) {
            day.highest_deg = elevation;
            day.highest_utc_s = s;
        }
        day.lowest_deg = fmin(day.lowest_deg, elevation);
    }
    day.first_deg = elevation_at(&day, 0);
    day.last_deg = elevation_at(&day, DAY_S);
    /* Between the neighbours of the highest one there is one maximum. */
    double low = fmax(day.highest_utc_s - STEP_S, 0), high = fmin(day.highest_utc_s + STEP_S, DAY_S);
    while (high - low > 1) {
        double third = (high - low) / 3;
        if (elevation_at(&day, low + third) < elevation_at(&day, high - third))
            low += third;
        else
            high -= third;
    }
    day.highest_deg = elevation_at(&day, low);
    day.highest_utc_s = day.midnight.utc_s + low;
    return day;
}

static double passage_between(const SunDay *day, double elevation_deg, double from, double to) {
    bool rising = elevation_at(day, from) < elevation_deg;
    while (to - from > 0.5) {
        double middle = (from + to) / 2;
        *((elevation_at(day, middle) < elevation_deg) == rising ? &from : &to) = middle;
    }
    return from;
}

int sun_day_passages(const SunDay *day, double elevation_deg, Passage passages[MOST_PASSAGES]) {
    int count = 0;
    double before = day->first_deg;
    for (int s = STEP_S; s <= DAY_S && count < MOST_PASSAGES; s += STEP_S) {
        double now = elevation_at(day, s);
        if ((before < elevation_deg) != (now < elevation_deg)) {
            double at = passage_between(day, elevation_deg, s - STEP_S, s);
            passages[count++] = (Passage){day->midnight.utc_s + at, now > before};
        }
        before = now;
    }
    return count;
}

double sun_refraction_deg(double elevation_deg) {
    if (elevation_deg < -2) return 0;
    return fmax(1.02 / 60 / tan((elevation_deg + 10.3 / (elevation_deg + 5.11)) * degree), 0);
}
