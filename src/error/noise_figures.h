/* Figures of the noise that noise.h measures: of tiles, of the whole picture, and what they may be. */
#pragma once

#include "error/noise.h"

/* Returns a tile's part of the squared error: the estimated variance of the mean, averaged over the channels
 * and summed over the tile's pixels. The estimate is for `samples` samples of each pixel, which may be more
 * than the tile has now. Returns INFINITY while it is not known. */
double noise_of_tile(const Noise *noise, const NoiseTile *tile, NoiseMeasure measure, double samples);

/* Returns the parts of noise_of_tile(): that of `samples` samples, and that of `paths` light paths. */
double noise_of_samples(const Noise *noise, const NoiseTile *tile, NoiseMeasure measure, double samples);
double noise_of_light(const Noise *noise, const NoiseTile *tile, NoiseMeasure measure, double paths);

/* Returns the estimated error of the whole picture, or INFINITY while it is not known. */
double noise_error(const Noise *noise, NoiseMeasure measure);

/* The RMS of the picture in levels, and of its worst tile. INFINITY while they are not known. */
void noise_levels(const Noise *noise, double *rms, double *worst_tile);

/* Returns the squared error at which the picture's figure is `error`, leaving its tiles aside. It is a sum of
 * noise_of_tile() over all tiles. */
double noise_goal(const Noise *noise, NoiseMeasure measure, double error);

/* Returns the squared error that a tile may have so that the picture's figure can be `error`. It is INFINITY
 * if the measure judges no tiles. */
double noise_tile_goal(const NoiseTile *tile, NoiseMeasure measure, double error);

/* Scales the variances of film_read_variance(), 3 for each pixel, so that each tile's sum agrees with
 * noise_of_tile(). The variances know which pixels are noisier than others; the tile's estimate knows how
 * much better a low-discrepancy sequence is than the scatter of its groups of samples. Variances that are not
 * known stay as they are. Pixels that are left out have no part in the sums. */
void noise_calibrate(const Noise *noise, float *variance);
