/* Errors between two pictures, as this project defines them. */
#pragma once

#include "base/error.h"
#include "image/image.h"

/* All figures are over the channels R, G, B of the finite pixels that the mask admits.
 *
 * If a figure is divided by a mean of 0, it is 0 where the pictures are equal and infinite where they are
 * not. If no pixel is finite, the percentages are infinite, so that such pictures are within no bound. */
typedef struct Comparison {
    /* Pixels that the mask admits. */
    long pixels;
    /* Those of them that are not finite in one of the pictures. They are left out of all figures below. */
    long nonfinite;
    /* sqrt(mean((a - b)^2)) / mean(b). */
    double rel_rmse_percent;
    /* The same without the 0.1 % of the pixels that differ most. mean(b) is over all pixels. */
    double trimmed_percent;
    /* mean(a) / mean(b) - 1 of each channel. */
    double bias_percent[3];
    /* The largest |a - b| / mean(b). */
    double largest_percent;
    /* The 99th percentile of |a - b| / mean(b), by nearest rank. */
    double p99_percent;
    /* Whether a picture of standard errors was given that is above 0 somewhere. */
    bool has_z;
    /* The mean of ((a - b) / se)^2 where the standard error se is above 0. */
    double mean_z2;
    /* The share of |z| > 4. */
    double share_z4_percent;
} Comparison;

/* Compares `a` with the reference `b`. `standard_error` and `mask` may be NULL. A mask admits the pixels
 * whose red is above 0.5. Fails with STATUS_USAGE if the sizes differ or the mask admits no pixel. */
MUST_CHECK bool compare_images(const Image *a, const Image *b, const Image *standard_error, const Image *mask,
                               Comparison *result, Error *error);
