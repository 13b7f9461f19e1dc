/* Where the sun stands. Its direction is computed here and nowhere else. */
#pragma once

typedef struct Sun {
    /* Above the horizon, from -90 to 90. */
    double elevation_deg;
    /* From +z toward +x. */
    double azimuth_deg;
    /* Of the disk as it is seen. */
    double radius_deg;
    /* The unit vector toward the sun. */
    double direction[3];
    /* The level unit vector toward the sun's azimuth. It does not vanish when the sun is at the zenith. */
    double level[3];
} Sun;

/* The sun at these angles, with its vectors. A Sun whose angles change is made anew by this function, so that
 * its vectors always belong to its angles. */
Sun sun_at(double elevation_deg, double azimuth_deg, double radius_deg);
