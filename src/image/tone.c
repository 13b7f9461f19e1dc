#include "image/tone.h"

#include <math.h>

/* To [0,1]. Negative and NaN become 0, +inf 1. */
static double tone_apply(Tone tone, double x) {
    if (!(x > 0)) return 0;
    if (tone != TONE_AUTHOR) return fmin(x, 1);
    x = fmin(x, 1e6); /* far above the curve's end, and its square is finite */
    return fmin(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 1);
}

/* IEC 61966-2-1. */
static double srgb_from_linear(double v) {
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1 / 2.4) - 0.055;
}

double tone_level(Tone tone, double gain, double radiance) {
    double light = tone_apply(tone, gain * radiance);
    return 255 * (tone == TONE_SCREEN ? light : srgb_from_linear(light));
}

double tone_levels_per_percent(Tone tone) {
    double most = 0;
    for (double x = 1e-4; x < 100; x *= 1.01)
        most = fmax(most, tone_level(tone, 1, 1.01 * x) - tone_level(tone, 1, x));
    return most;
}

double tone_light_of_level(double level) {
    double v = level / 255;
    return v <= 12.92 * 0.0031308 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}
