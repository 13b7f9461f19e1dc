/* The sun's way over a day, for the time-lapse. If the scene says when and where it is (scene/sun_clock.h),
 * it is the real day there. If not, the day is an equinox, and the way leads through the place where the sun
 * stands at the beginning. */
#pragma once

#include "scene/scene_values.h"

typedef struct Day {
    /* The real day's moment and place, if this clock runs. The rest then has no meaning. */
    SunClock clock;
    /* Hours from noon, -12 to 12. */
    double hour;
    /* The sun's elevation at noon. It is 60, as in the paper, or more if the sun stands higher at the
     * beginning. */
    double noon_deg;
    double noon_azimuth_deg;
} Day;

/* Returns the real day, or the morning hour when the sun passes the place where it stands. If that is below
 * the horizon, it is late at night. */
Day day_of(const SceneValues *values);

/* Advances the time. The dark part of the night is left out: after the evening's -18 degrees comes the
 * morning's. A polar night of a whole day is played. */
void day_advance(Day *day, double hours);

/* Returns how many hours of the day are played. */
double day_length(const Day *day);

/* Puts the sun where it stands now. */
void day_apply(const Day *day, SceneValues *values);
