/* What a picture can tell beside its light (arbitrary output variables), as layers of the image.
 *
 * Albedo, normal and depth are those of the first hits of the picture's own camera rays, of the first
 * AOV_MOST_SAMPLES of each pixel, with a program and a target of their own: a picture without them costs
 * nothing more. */
#pragma once

#include "render/renderer.h"

enum { AOV_MOST_SAMPLES = 256 };

enum {
    /* albedo.R .G .B: the mean of the material's albedo or the mirror's tint, in [0,1]; a miss counts as 0.
     */
    AOV_ALBEDO = 1,
    /* normal.X .Y .Z: the mean of the unit normals toward the camera, in the world's axes; a miss counts as
     * 0, so that the mean is shorter on an edge. */
    AOV_NORMAL = 2,
    /* Z: the mean of what was hit, along the camera's axis and not along the ray, m; 1e10 where nothing was,
     * as Cycles has it. */
    AOV_DEPTH = 4,
    /* samples.Y: samples in the pixel's mean. Those that were not finite are not. */
    AOV_SAMPLES = 8,
    /* variance.R .G .B: of the pixel's mean, estimated as gl/film.h says; NaN where it is not known. */
    AOV_VARIANCE = 16
};

typedef struct Aov {
    unsigned kinds;
    Program program; /* empty unless one of the first three is asked for */
    Target target;
    unsigned samples; /* a pixel */
    double pixels_per_second;
} Aov;

/* The kinds of a list such as "albedo,normal"; NULL is none. STATUS_USAGE for names that are not known or
 * come twice. */
MUST_CHECK bool aov_parse(const char *list, unsigned *kinds, Error *error);

/* For the pictures of `renderer`, which was made with the same parameters and, for AOV_VARIANCE, with a film
 * that knows its error. */
MUST_CHECK bool aov_create(Aov *aov, unsigned kinds, const Context *context, const RenderParams *params,
                           const Renderer *renderer, Error *error);
void aov_destroy(Aov *aov);

/* Catches up with the picture's `samples`, a mean pixel's. When `stop` (may be NULL) says yes, what it has so
 * far has to do: if that is nothing, as in a picture that is stopped in its first group, one sample a pixel.
 */
MUST_CHECK bool aov_pass(Aov *aov, const Renderer *renderer, uint64_t samples, bool (*stop)(void),
                         Error *error);

/* Forgets the layers and starts anew for another size, camera or parameters of the same scene. */
MUST_CHECK bool aov_restart(Aov *aov, const Context *context, const RenderParams *params,
                            const Renderer *renderer, Error *error);

/* The first hits of one pixel's first camera rays. */
typedef struct AovPixel {
    double albedo[3]; /* means as above */
    double depth;
    double hits; /* share of the rays that hit something */
} AovPixel;

MUST_CHECK bool aov_read_pixel(const Aov *aov, unsigned samples, int x, int y, AovPixel *pixel, Error *error);

/* Adds the layers to the image that was read from `film`. */
MUST_CHECK bool aov_read(const Aov *aov, const Film *film, Image *image, Error *error);

/* The layer of variances that aov_read() added; NULL where they were not asked for. */
float *aov_variance(const Aov *aov, const Image *image);
