/* The sun's way over a day, for the time-lapse. The day is an equinox, and the way leads through the place
 * where the sun stands at the beginning. */
#pragma once

typedef struct Day {
    /* Hours from noon, -12 to 12. */
    double hour;
    /* The sun's elevation at noon. It is 60, as in the paper, or more if the sun stands higher at the
     * beginning. */
    double noon_deg;
    double noon_azimuth_deg;
} Day;

/* Returns the morning hour when the sun passes this place. If the sun is below the horizon, this is late at
 * night. */
Day day_through(double elevation_deg, double azimuth_deg);

/* Advances the time. The dark part of the night is left out: after the evening's -18 degrees comes the
 * morning's. */
void day_advance(Day *day, double hours);

/* Returns how many hours of the day are played. */
double day_length(const Day *day);

void day_sun(const Day *day, double *elevation_deg, double *azimuth_deg);
