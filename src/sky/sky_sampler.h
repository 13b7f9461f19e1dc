/* Directions sampled from the sky in proportion to its luminance: the sky's patches are cut into bins of
 * equal probability (glsl/pass/sky_sampler.glsl). */
#pragma once

#include "sky/sky_patches.h"

enum { SKY_BIN_COLUMNS = 256, SKY_BIN_ROWS = 128, SKY_BINS = SKY_BIN_COLUMNS * SKY_BIN_ROWS };

extern const ResourceKind sky_sampler;

/* Shares SKY_BINS bins among cells in proportion to their weights. Numbers of bins are whole, and each
 * cell with a weight above 0 gets at least one. There must be at least one such cell and fewer of them
 * than bins. */
void sky_sampler_share(const double *weights, int cells, int *bins);
