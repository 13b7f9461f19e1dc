/* How far a film is from its own limit: an estimate of the noise that is left in the mean, pixel by pixel and
 * for the whole picture.
 *
 * The mean M of n samples is compared with what it was after n/2. Where samples are independent, E (M_n -
 * M_n/2)^2 is V(n/2) - V(n) = V(n), V the variance of the mean. Points of a low-discrepancy sequence are not,
 * and V falls by more than a half with each doubling, by q, say. But the same identity holds level by level
 * for Owen's scrambling, whose halves are exchangeable, and so V(n) = sum over the doublings still to come of
 * what each will change = change q / (1 - q). q is measured over the whole picture from the last two changes.
 * Measured: 0.38 to 0.46 for sobol, 0.5 for random; half way between that and 1/2 is taken, which errs by a
 * few percent to the safe side.
 *
 * The picture is cut into tiles that may have different numbers of samples. Their numbers must be doubled
 * from time to time, or nothing new is learnt; in between, V ~ 1/n is assumed. */
#pragma once

#include "gl/camera.h"
#include "image/image.h"

enum { NOISE_TILE = 16 }; /* pixels a side */

/* Where the sun itself is in the picture, errors are judged without so many of the pixels, the worst. */
#define NOISE_SUN_TRIM 0.001

typedef struct NoiseTile {
    Rectangle pixels;
    uint64_t samples;  /* a pixel, now */
    uint64_t measured; /* samples when it was measured last */
    int times;         /* that it was measured */
    double change;  /* sum over pixels of the mean squared change of channels, by the last doubling; after 2
                       times */
    double earlier; /* the same by the doubling before; after 3 times */
} NoiseTile;

typedef struct Noise {
    int width, height, columns, rows;
    NoiseTile *tiles; /* columns * rows, by rows */
    float *before;    /* 3 a pixel: the mean that the next one is compared with */
    float *change;    /* a pixel: squared change by the last doubling, mean of the channels */
    double trim;      /* share of the pixels, the worst, that the picture's figure leaves out */
    float worst;      /* squared change of a pixel beyond which it is one of these */
    double fall;      /* q as it is taken */
    double measured_fall;
    double mean; /* of the picture, over pixels and channels */
} Noise;

/* `trim`: 0, or a share such as 0.001. */
Noise noise_create(int width, int height, double trim);
void noise_destroy(Noise *noise);

/* Takes in the picture's mean as it is now. `tiles[i].samples` says how much is in it; tiles that have
 * doubled since the last time are measured, the others wait. */
void noise_measure(Noise *noise, const Image *mean);

/* A tile's share of the squared error: sum over its pixels of the estimated variance of the mean, mean of the
 * channels; INFINITY where it is not known. At `samples`, or what it will have then. */
double noise_of_tile(const Noise *noise, const NoiseTile *tile, double samples);

/* Estimated relRMSE of the whole picture, percent, as the comparison defines it; INFINITY while it is not
 * known. */
double noise_percent(const Noise *noise);

/* The squared error, as the sum of noise_of_tile() over all tiles, at which noise_percent() is `percent`. */
double noise_goal(const Noise *noise, double percent);

/* Scales variances of the pixels' means (3 a pixel, of film_read_variance()) so that each tile's sum is what
 * is estimated here: they know which pixels are noisier than others, and this knows how much better a
 * low-discrepancy sequence is than its groups' scatter tells. What is not known stays as it is. */
void noise_calibrate(const Noise *noise, float *variance);
