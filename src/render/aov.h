/* Arbitrary output variables (AOVs): what a picture can give beside its light, as layers of the image.
 *
 * Albedo, normal and depth are those of the first surfaces that the camera rays meet, and the transmittance
 * is that of the mist before them, for the first AOV_MOST_SAMPLES samples of each pixel. They have a program
 * and a target of their own, so a picture without them costs nothing more. */
#pragma once

#include "render/renderer.h"

enum { AOV_MOST_SAMPLES = 256 };

enum {
    /* albedo.R .G .B: the mean of the material's albedo or the mirror's tint, in [0,1]. A ray that hits
     * nothing counts as 0. */
    AOV_ALBEDO = 1,
    /* normal.X .Y .Z: the mean of the unit normals toward the camera, in the world's axes. A ray that hits
     * nothing counts as 0, so the mean is shorter on an edge. */
    AOV_NORMAL = 2,
    /* Z: the mean depth of the hits along the camera's axis (not along the ray), in m; 1e10 where no ray hit
     * anything, as in Cycles. */
    AOV_DEPTH = 4,
    /* samples.Y: the number of samples in the pixel's mean. Samples that were not finite are left out. */
    AOV_SAMPLES = 8,
    /* variance.R .G .B: the estimated variance of the pixel's mean (see gl/film.h); NaN where it is not
     * known. */
    AOV_VARIANCE = 16,
    /* transmittance.Y: the mean share of the light that the mist lets through, to the hit or, where a ray
     * hits nothing, through all of it. 1 where there is no mist. */
    AOV_TRANSMITTANCE = 32
};

typedef struct Aov {
    unsigned kinds;
    /* Empty if none of albedo, normal, depth and transmittance is wanted. */
    Program program;
    Target target;
    /* The number of the picture's first sample, and the samples taken of each pixel. */
    unsigned first, samples;
    /* The part of the picture that is drawn. */
    Rectangle area;
    Pace pace;
} Aov;

/* Reads a list such as "albedo,normal" into bits; NULL is none. An unknown name or one that comes twice is
 * STATUS_USAGE. */
MUST_CHECK bool aov_parse(const char *list, unsigned *kinds, Error *error);

/* Creates the layers for the pictures of `renderer`, which was made with the same parameters. AOV_VARIANCE
 * needs a film with FILM_SCATTER. */
MUST_CHECK bool aov_create(Aov *aov, unsigned kinds, const Context *context, const RenderParams *params,
                           const Renderer *renderer, Error *error);
void aov_destroy(Aov *aov);

/* Takes samples until there are as many as the picture has, which is `samples` in the mean of its pixels. If
 * `stop` (may be NULL) returns true, it ends with the samples that it has. */
MUST_CHECK bool aov_pass(Aov *aov, const Renderer *renderer, uint64_t samples, bool (*stop)(void),
                         Error *error);

/* Takes a first sample of each pixel if none is taken yet. Call it before the layers are read. */
MUST_CHECK bool aov_complete(Aov *aov, Error *error);

/* Saves the layers so far, or loads them. */
MUST_CHECK bool aov_archive(Aov *aov, Archive *archive, Error *error);

/* Removes the layers and starts anew for another size, camera or parameters of the same scene. */
MUST_CHECK bool aov_restart(Aov *aov, const Context *context, const RenderParams *params,
                            const Renderer *renderer, Error *error);

/* The first hits of one pixel's first camera rays. */
typedef struct AovPixel {
    /* The means of albedo and so on are as above. */
    double albedo[3];
    double depth;
    /* The share of the rays that hit something. */
    double hits;
} AovPixel;

MUST_CHECK bool aov_read_pixel(const Aov *aov, unsigned samples, int x, int y, AovPixel *pixel, Error *error);

/* Adds the layers to `image`, which was read from `film`. */
MUST_CHECK bool aov_read(const Aov *aov, const Film *film, Image *image, Error *error);

/* The layer of variances that aov_read() added, or NULL if it was not wanted. The image owns it. */
float *aov_variance(const Aov *aov, const Image *image);
