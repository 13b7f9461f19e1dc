/* What is known of a picture's error, and whether more samples can lessen it. */
#include "error/adaptive.h"
#include "error/noise_figures.h"

#include <math.h>

/* A round without a plan may be due to roundings. So many in turn are not. */
enum { AIMLESS_ROUNDS = 3 };

/* In a picture in which no path has found light so far, all of it may be found only by luck. */
static const uint64_t paths_of_black = (uint64_t)1 << 20;

double adaptive_error(const Adaptive *adaptive, NoiseMeasure measure) {
    /* Light that few samples find, such as that of a lamp without a hint, would be missed by an earlier
     * estimate. In a black picture all of it may be missing. */
    if (!adaptive->claimed || adaptive->noise.largest <= 0) return INFINITY;
    return noise_error(&adaptive->noise, measure);
}

AdaptiveEnd adaptive_end(const Adaptive *adaptive) {
    bool black = adaptive->claimed && adaptive->noise.largest <= 0 && adaptive->paths >= paths_of_black;
    if (black) return ADAPTIVE_BLACK;
    if (adaptive->idle) return ADAPTIVE_FULL;
    if (adaptive->beyond >= 2) return ADAPTIVE_BEYOND;
    return adaptive->aimless >= AIMLESS_ROUNDS ? ADAPTIVE_AIMLESS : ADAPTIVE_GOES_ON;
}
