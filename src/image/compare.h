/* Errors between two pictures, as this project defines them. */
#pragma once

#include "base/error.h"
#include "image/image.h"

/* All over the finite pixels that the mask admits, channels R, G, B. Percent where it says so. What is
 * divided by a mean of 0 is inf, unless the pictures are equal there: 0. With no finite pixel, the
 * percentages are inf: such pictures are within no bound. */
typedef struct Comparison {
    long pixels;             /* admitted by the mask */
    long nonfinite;          /* of these, not finite in either picture: left out of all below */
    double rel_rmse_percent; /* sqrt(mean((a - b)^2)) / mean(b) */
    double
        trimmed_percent; /* the same without the 0.1 % of pixels that differ most; mean(b) over all pixels */
    double bias_percent[3];  /* mean(a) / mean(b) - 1, a channel each */
    double largest_percent;  /* largest |a - b| / mean(b) */
    double p99_percent;      /* 99th percentile of the same, by nearest rank */
    bool has_z;              /* a picture of standard errors was given, with se > 0 somewhere */
    double mean_z2;          /* mean of ((a - b) / se)^2 where se > 0 */
    double share_z4_percent; /* share of |z| > 4, in percent */
} Comparison;

/* `b` is the reference. `standard_error` and `mask` may be NULL; a mask admits pixels whose red is above 0.5.
 * STATUS_USAGE unless all have the same size and the mask admits a pixel. */
MUST_CHECK bool compare_images(const Image *a, const Image *b, const Image *standard_error, const Image *mask,
                               Comparison *result, Error *error);
