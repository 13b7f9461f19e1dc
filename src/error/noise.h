/* Estimates the noise that is left in the mean of a film, for each tile of pixels and for the whole picture.
 *
 * The mean M_n of n samples is compared with the mean M_n/2 of the first half of them. Let V(n) be the
 * variance of M_n. If samples are independent, the expectation of (M_n - M_n/2)^2 is V(n/2) - V(n), which
 * equals V(n).
 *
 * Points of a low-discrepancy sequence are not independent. With each doubling, V is multiplied by a factor q
 * that is below 1/2. The two halves of a sequence scrambled as Owen does are statistically alike, so
 * E (M_n - M_n/2)^2 = V(n/2) - V(n) holds for each doubling. V(n) is then the sum of the changes that all
 * doublings still to come will make: change * q / (1 - q).
 *
 * q is measured over the whole picture, from the last two changes. It is 0.38 to 0.46 for sobol and 0.5 for
 * random. The estimate uses the mean of the measured q and 1/2, which makes it a few percent too large.
 *
 * Tiles may have different numbers of samples. A tile is measured only when its number of samples has
 * doubled. Between measurements V ~ 1/n is assumed. */
#pragma once

#include <stdint.h>

#include "gl/camera.h"
#include "image/image.h"

/* Width and height of a tile, in pixels. */
enum { NOISE_TILE = 16 };

/* If the sun's image is in the picture, this share of the pixels, the worst, is left out of the error figure.
 */
#define NOISE_SUN_TRIM 0.001

typedef struct NoiseTile {
    Rectangle pixels;
    /* Samples of each pixel, now. */
    uint64_t samples;
    /* Samples of each pixel when the tile was last measured. */
    uint64_t measured;
    /* How often the tile was measured. */
    int times;
    /* The change by the last doubling: the squared change, averaged over the channels and summed over the
     * pixels. Known after 2 measurements. */
    double change;
    /* The change by the doubling before that one. Known after 3 measurements. */
    double earlier;
} NoiseTile;

typedef struct Noise {
    int width, height, columns, rows;
    /* columns * rows tiles, row by row. */
    NoiseTile *tiles;
    /* 3 numbers for each pixel: the mean that the next mean is compared with. */
    float *before;
    /* For each pixel: the squared change by the last doubling, averaged over the channels. */
    float *change;
    /* The share of the pixels, the worst, that the picture's figure leaves out. */
    double trim;
    /* Pixels whose squared change is larger than this are left out. */
    float worst;
    /* The q that the estimate uses. */
    double fall;
    double measured_fall;
    /* The picture's mean over pixels and channels. */
    double mean;
} Noise;

/* `trim` is 0, or a share of the pixels such as NOISE_SUN_TRIM. */
Noise noise_create(int width, int height, double trim);
void noise_destroy(Noise *noise);

/* Compares the picture's mean with the mean before. The caller has set `tiles[i].samples` to the samples in
 * it. Tiles whose samples have doubled since their last measurement are measured; the others wait. */
void noise_measure(Noise *noise, const Image *mean);

/* Returns a tile's part of the squared error: the estimated variance of the mean, averaged over the channels
 * and summed over the tile's pixels. The estimate is for `samples` samples of each pixel, which may be more
 * than the tile has now. Returns INFINITY while it is not known. */
double noise_of_tile(const Noise *noise, const NoiseTile *tile, double samples);

/* Returns the estimated relRMSE of the whole picture in percent, as image/compare.h defines it. Returns
 * INFINITY while it is not known. */
double noise_percent(const Noise *noise);

/* Returns the squared error at which noise_percent() is `percent`. It is a sum of noise_of_tile() over all
 * tiles. */
double noise_goal(const Noise *noise, double percent);

/* Scales the variances of film_read_variance(), 3 for each pixel, so that each tile's sum agrees with
 * noise_of_tile(). The variances know which pixels are noisier than others; the tile's estimate knows how
 * much better a low-discrepancy sequence is than the scatter of its groups of samples. Variances that are not
 * known stay as they are. */
void noise_calibrate(const Noise *noise, float *variance);
