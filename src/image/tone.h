/* How a radiance is shown: the tone curve, and the encoding of sRGB behind it. */
#pragma once

typedef enum Tone {
    /* The author's tone curve, Narkowicz's fit of ACES. */
    TONE_AUTHOR,
    /* Clamp at 1. */
    TONE_NONE,
    /* The values are what a screen is given: they are neither curved nor encoded. */
    TONE_SCREEN
} Tone;

/* The level from 0 to 255 that a radiance is shown as, neither rounded nor dithered. The radiance is
 * multiplied by `gain`, 2^exposure. Negative radiances and NaN are shown as 0, infinity as 255. */
double tone_level(Tone tone, double gain, double radiance);

/* The most levels by which a picture changes if its radiance changes by a percent. */
double tone_levels_per_percent(Tone tone);

/* The light from 0 to 1 that is shown at that level: the inverse of tone_level() with TONE_NONE. */
double tone_light_of_level(double level);
