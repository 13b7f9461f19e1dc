/* Errors between two pictures, as this project defines them. */
#pragma once

#include "base/error.h"
#include "image/image.h"
#include "image/levels.h"

/* A zeroed struct is the default. */
typedef struct CompareOptions {
    /* Adds the figures of z. May be NULL. */
    const Image *standard_error;
    /* Admits the pixels whose red is above 0.5. May be NULL. */
    const Image *mask;
    /* The pixels of the sun's own image (image/sun_pixels.h), which are left out. May be NULL. */
    const unsigned char *sun;
    /* Filled with one byte a pixel: 1 where the pictures are compared and finite, else 0. May be NULL. */
    unsigned char *compared;
    /* How the pictures are shown, for the levels. */
    Tone tone;
    double exposure_ev;
} CompareOptions;

/* All figures are over the channels R, G, B of the finite pixels that the mask admits and that do not hold
 * the sun's image.
 *
 * If a figure is divided by a mean of 0, it is 0 where the pictures are equal and infinite where they are
 * not. If no pixel is finite, the percentages are infinite, so that such pictures are within no bound. */
typedef struct Comparison {
    /* Pixels that are compared: the mask admits them, both files held them, and they do not hold the sun's
     * image. */
    long pixels;
    /* Pixels that the mask admits, but that hold the sun's image. They are left out of all figures below. */
    long sun_pixels;
    /* Pixels that the mask admits, but that one of the files did not hold (image_holds). They are left out of
     * all figures below. */
    long outside;
    /* Those of the compared pixels that are not finite in one of the pictures, and the first of them. They
     * are left out of all figures below. */
    long nonfinite;
    int nonfinite_x, nonfinite_y;
    /* sqrt(mean((a - b)^2)) / mean(b). */
    double rel_rmse_percent;
    /* The same without the 0.1 % of the pixels that differ most. They are left out of mean(b) too. */
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
    /* One of the pictures is light as it is shown (Image.shown), so that only the levels mean something. */
    bool levels_only;
    /* The difference in 8-bit levels of the pictures as they are shown. */
    Levels levels;
} Comparison;

/* Compares `a` with the reference `b`. `options` may be NULL. Fails with STATUS_USAGE if the sizes differ or
 * no pixel is left to compare. */
MUST_CHECK bool compare_images(const Image *a, const Image *b, const CompareOptions *options,
                               Comparison *result, Error *error);
