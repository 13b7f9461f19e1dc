/* The noise of a merged picture. */
#pragma once

#include "error/merge_sums.h"
#include "error/merged.h"

/* How the noise of parts is found while they are added. */
typedef struct MergeNoise {
    /* The pixels that each part has; parts of the same pixels follow each other's doublings in one Noise. */
    int area_count;
    Rectangle *areas;
    Noise *noises;
    /* How many parts each area has. */
    int *parts;
    /* Whether areas overlap, so that no noise can be told. */
    bool mixed;
    /* Pixels to leave out: the sun's own image. */
    unsigned char *sun;
} MergeNoise;

/* Finds the areas of the parts, and the sun's own image. */
MUST_CHECK bool merge_noise_create(MergeNoise *noise, const Merge *merge, Error *error);
void merge_noise_free(MergeNoise *noise);

/* Measures the picture so far, after a part was added. */
void merge_noise_measure(MergeNoise *noise, const Part *part, const MergeSums *sums);

/* The noise of the picture in percent, or INFINITY. */
double merge_noise_percent(const MergeNoise *noise, const Merge *merge);

/* Scales the variances of the picture to the noise (noise_calibrate()). */
void merge_noise_calibrate(const MergeNoise *noise, float *variance);
