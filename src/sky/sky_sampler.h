/* Directions drawn from the sky in proportion to its luminance: the sky's patches cut into bins of one
 * probability (glsl/pass/sky_sampler.glsl). */
#pragma once

#include "sky/sky_patches.h"

enum { SKY_BIN_COLUMNS = 256, SKY_BIN_ROWS = 128, SKY_BINS = SKY_BIN_COLUMNS * SKY_BIN_ROWS };

extern const ResourceKind sky_sampler;

/* Shares SKY_BINS bins among cells in proportion to their weights, in whole numbers, at least one bin to each
 * cell of a weight above 0 (fewer of those than bins, and at least one). */
void sky_sampler_share(const double *weights, int cells, int *bins);
