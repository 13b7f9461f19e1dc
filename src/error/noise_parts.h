/* For the files noise*.c: what the measurements in noise.c and the figures in noise_figures.c share. */
#pragma once

#include "error/noise.h"

static inline int noise_tile_count(const Noise *noise) {
    return noise->columns * noise->rows;
}

/* The index of the tile's pixel k. */
size_t noise_pixel(const Noise *noise, const Rectangle *tile, int k);

/* Whether the measure is measured. */
bool noise_measures(const Noise *noise, NoiseMeasure measure);

/* Returns the factor that is left of a change after `levels` more doublings. */
double noise_fallen(const NoiseFigures *figures, double levels);

/* The factor for an estimate from pixels whose squared changes and their squares have these sums. */
double noise_caution(NoiseMeasure measure, double changes, double squares);
