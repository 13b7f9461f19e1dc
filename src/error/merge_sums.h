/* The sums of a merged picture, which are added up part by part, exactly. */
#pragma once

#include "error/part.h"
#include "render/chance.h"

/* A sum in two doubles, of which the second is what the first has no digits for. */
typedef struct ExactSum {
    double high, low;
} ExactSum;

typedef struct MergeSums {
    int width, height;
    unsigned layers;
    /* 3 for each pixel; `light` is NULL if the parts have no second sum. */
    ExactSum *radiance, *light;
    /* Of each pixel: its samples, and the light paths whose light it has (NULL without a second sum). */
    double *accepted, *rejected, *light_paths;
    /* 4 for each pixel: those of gl/film.h; NULL if the parts have none. */
    double *scatter, *chance, *squares;
    double light_scale;
} MergeSums;

MergeSums merge_sums_create(int width, int height, const Part *part);
void merge_sums_free(MergeSums *sums);

/* Adds the layers of a part, all in the size of the picture. */
MUST_CHECK bool merge_sums_add(MergeSums *sums, const Part *part, Error *error);

/* The picture of the sums so far, and the second sum's part of it (4 floats a pixel, or NULL). Both are to be
 * freed. */
Image merge_sums_mean(const MergeSums *sums, float **light);

/* The map of what is left to chance, empty if the parts have none. To be freed. */
ChanceMap merge_sums_chance(const MergeSums *sums);

/* Adds the sums as layers of a part. */
void merge_sums_add_layers(const MergeSums *sums, Image *image);

/* The variances as film_read_variance() has them: 3 floats a pixel. */
void merge_sums_variance(const MergeSums *sums, float *rgb);
