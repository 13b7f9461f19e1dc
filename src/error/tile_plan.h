/* The plan of adaptive sampling: how often each tile is to be doubled so that the picture reaches a target.
 */
#pragma once

#include "error/noise.h"

/* No tile may have more samples of a pixel, because a film counts up to 2^24. */
#define TILE_MOST_SAMPLES ((uint64_t)1 << 23)

/* Sets `doublings`, one number for each tile, and returns the number of doublings of the light paths. The
 * picture's error is to be `target` in `measure` afterwards. */
int tile_plan(const Noise *noise, NoiseMeasure measure, double target, int *doublings);
