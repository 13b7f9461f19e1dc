/* Noise measured: the same picture from several seeds, and whether two such agree pixel by pixel. */
#pragma once

#include "image/image.h"

#include <stdbool.h>

enum { SPREAD_SEEDS = 8, SPREAD_MOST_VALUES = 3 * 256 * 256 };

/* A picture's mean over the seeds and the variance of that mean, by channel. */
typedef struct Spread {
    int values;
    double mean[SPREAD_MOST_VALUES], variance[SPREAD_MOST_VALUES];
} Spread;

/* Renders size x size pixels with seeds from `first_seed` on; skips the test where there is no OpenGL. */
void spread_render(const char *scene, const char *arguments, int size, int first_seed, Spread *spread);

/* What two spreads say of each other. Expected: mean z^2 as Student's t with Welch's degrees of freedom makes
 * it. */
typedef struct Agreement {
    double difference, z2, expected, far; /* relative difference of the means; share of |z| > 4 */
} Agreement;

Agreement spread_agreement(const Spread *a, const Spread *b);

/* Whether a pixel is off all edges: the picture is nearly even two pixels around it. */
bool spread_even_around(const Image *image, int x, int y);
