/* What the sun does on a day at a place: when it passes an elevation, and when it is highest. */
#pragma once

#include "scene/almanac.h"
#include "scene/moment.h"

enum { MOST_PASSAGES = 8 };

/* The sun passes an elevation. */
typedef struct Passage {
    double utc_s;
    bool rising;
} Passage;

typedef struct SunDay {
    Moment midnight;
    Place place;
    /* The elevations at 00:00 and at the next 00:00 by the clock, and the highest and the lowest of the day.
     */
    double first_deg, last_deg, highest_deg, lowest_deg;
    double highest_utc_s;
} SunDay;

/* The elevation of the sun's middle at which its upper edge is on a level horizon. Refraction lifts the edge
 * by 34 minutes of arc, and the sun's radius is 16: the convention of almanacs. */
extern const double sunrise_elevation_deg;

/* The day of the moment's own clock. */
SunDay sun_day(const Moment *moment, const Place *place);

/* Finds when the sun's middle passes this elevation, to a second and in order. Returns how many passages
 * there are. A day has at most two, or three where a clock's midnight is near one of them. */
int sun_day_passages(const SunDay *day, double elevation_deg, Passage passages[MOST_PASSAGES]);

/* Refraction, in degrees, of light that comes from this elevation above the air, near the sea at 10 degrees
 * Celsius. It is good to 0.002 degrees above the horizon (Saemundsson 1986), and 0 for a sun that has set for
 * long. */
double sun_refraction_deg(double elevation_deg);
