/* What a picture can tell beside its light (arbitrary output variables), as layers of the image:
 *
 *   albedo    albedo.R .G .B   of the material at the first hit, or a mirror's tint, in [0,1]; 0 where
 * nothing is hit normal    normal.X .Y .Z   there, in the world's axes, toward the camera; 0 where nothing is
 * hit depth     Z                along the camera's axis (not along the ray), m; 1e10 where nothing is hit,
 * as Cycles does samples   samples.Y        in the pixel's mean; those that were not finite are left out
 *   variance  variance.R .G .B of the pixel's mean, estimated as gl/film.h says; NaN where it is not known
 *
 * The first three are means over the first AOV_MOST_SAMPLES samples of each pixel, the very rays of the
 * picture: albedo and normal over all of them, so that a normal is shorter than 1 on an edge, and depth over
 * those that hit. They have a program and a target of their own; a picture without them costs nothing more.
 */
#pragma once

#include "render/renderer.h"

enum { AOV_MOST_SAMPLES = 256 };

enum { AOV_ALBEDO = 1, AOV_NORMAL = 2, AOV_DEPTH = 4, AOV_SAMPLES = 8, AOV_VARIANCE = 16 };

typedef struct Aov {
    unsigned kinds;
    Program program; /* empty unless one of the first three is asked for */
    Target target;
    unsigned samples; /* a pixel */
    double rows_per_second;
} Aov;

/* The kinds of a list such as "albedo,normal"; NULL is none. STATUS_USAGE for names that are not known or
 * come twice.
 */
MUST_CHECK bool aov_parse(const char *list, unsigned *kinds, Error *error);

/* For the pictures of `renderer`, which was made with the same parameters and, for AOV_VARIANCE, with a film
 * that knows its error. */
MUST_CHECK bool aov_create(Aov *aov, unsigned kinds, const Context *context, const RenderParams *params,
                           const Renderer *renderer, Error *error);
void aov_destroy(Aov *aov);

/* Catches up with the renderer's film. When `stop` (may be NULL) says yes, what it has so far has to do: if
 * that is nothing, as in a picture that is stopped in its first group, one sample a pixel. */
MUST_CHECK bool aov_pass(Aov *aov, const Renderer *renderer, bool (*stop)(void), Error *error);

/* Adds the layers to the image that was read from `film`. */
MUST_CHECK bool aov_read(const Aov *aov, const Film *film, Image *image, Error *error);
