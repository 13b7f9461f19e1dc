/* A day's sun for the time-lapse: at an equinox, on an arc through where the sun stands when it begins. */
#pragma once

typedef struct Day {
    double hour;     /* from noon, -12 to 12 */
    double noon_deg; /* the sun's elevation at noon: 60, the paper's, or more if it stands higher already */
    double noon_azimuth_deg;
} Day;

/* The morning when the sun passes this place; where it is set, the last hours of a night. */
Day day_through(double elevation_deg, double azimuth_deg);

/* Time goes by. What is darker than the end of astronomical twilight is left out: after -18 degrees in the
 * evening comes the morning with the same. */
void day_advance(Day *day, double hours);

/* What is played of it, hours. */
double day_length(const Day *day);

void day_sun(const Day *day, double *elevation_deg, double *azimuth_deg);
