/* Noise measured: the same picture from several seeds, and whether two such agree pixel by pixel. */
#pragma once

#include "image/image.h"
#include "ztest.h"

#include <stdbool.h>

enum { SPREAD_SEEDS = 8, SPREAD_MOST_VALUES = 3 * 256 * 256 };

/* A picture's mean over the seeds and the variance of that mean, by channel. */
typedef struct Spread {
    int width, height, values;
    double mean[SPREAD_MOST_VALUES], variance[SPREAD_MOST_VALUES];
} Spread;

/* Renders with seeds from `first_seed` on; the arguments give the size. Where there are fewer samples
 * (support_samples()), the values are those of blocks of pixels (support_block()): few samples of one pixel
 * are far from normal. Ends the test where there is no OpenGL. */
void spread_render(const char *scene, const char *arguments, int first_seed, Spread *spread);

/* The mean as a picture, to be freed. */
Image spread_image(const Spread *spread);

/* Whether two spreads have the same mean, value by value and as a whole, within the noise of both (ztest.h).
 * Where not, the pictures are kept under `name` (failed.h) and the test fails. `comparisons` such tests share
 * the rate of false alarms. What was found is added to `pool` unless that is NULL: tests of several places
 * together have the sharper limits. */
void spread_expect_same(const char *name, const Spread *got, const Spread *wanted, long comparisons,
                        ZTest *pool);

/* Fails the test unless the mean of z^2 over all places is what it should be. */
void spread_expect_pool(const char *name, const ZTest *pool);

/* Whether a pixel is off all edges: the picture is nearly even two pixels around it. */
bool spread_even_around(const Image *image, int x, int y);
