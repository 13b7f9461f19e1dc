/* A picture that is put together from parts (error/merge.h). */
#pragma once

#include "error/noise.h"
#include "error/part.h"
#include "render/chance.h"

typedef struct Merge {
    /* In the order of their first samples. */
    Part *parts;
    int count;
    int width, height;
    /* The union of the layers that the parts have. All have the same. */
    unsigned layers;
    /* All of the samples: pieces, sums of light paths and so on. It has no path and no metadata. */
    Part whole;
    /* The merged picture, with its layers. */
    Image image;
    FilmCount samples;
    /* The least and the largest number of samples of a pixel. */
    uint64_t least, most;
    /* Pixels that no part has. */
    uint64_t missing;
    ChanceShares chance;
    /* The noise in percent, INFINITY if it is not known, and the pixels that it leaves out: the sun's image,
     * to be freed. */
    double noise_percent;
    unsigned char *sun;
} Merge;
