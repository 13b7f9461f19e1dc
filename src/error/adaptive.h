/* Adaptive sampling: the tiles whose next samples take the most off the picture's error get them, until what
 * is left is under the error asked for.
 *
 * Every round doubles the samples of some tiles. Which ones is planned with what the noise estimate promises:
 * the level of (squared error taken off) / (samples spent) is found at which, with doublings as often as they
 * are worth that much, the whole picture would reach its goal; tiles that have a doubling to come by that
 * plan get one. A pixel's samples so depend on what its tile looked like, which biases its mean; by tiles of
 * 256 pixels, by less than can be measured (README). */
#pragma once

#include "error/noise.h"
#include "render/renderer.h"

typedef struct Adaptive {
    Noise noise;
    uint64_t *wanted; /* samples that each tile is still to get in this round */
    Rectangle *regions;
    double deadline; /* of clock_seconds(), after which no group of samples is begun; INFINITY at first */
    uint64_t paths;  /* over all pixels */
    uint64_t least, most; /* samples of a pixel */
    int rounds;
} Adaptive;

/* For `renderer`, whose film is empty. `trim` as for noise_create(). */
Adaptive adaptive_create(const Renderer *renderer, double trim);
void adaptive_destroy(Adaptive *adaptive);

/* One round toward an estimated relRMSE of `percent`: all of the picture while nothing is known of it, and
 * then the tiles that the plan says. `stop` (may be NULL) as for renderer_pass(). */
MUST_CHECK bool adaptive_round(Adaptive *adaptive, Renderer *renderer, double percent, bool (*stop)(void),
                               Error *error);

/* One group of samples for all pixels, on the way to `samples` of each, which the film has not reached;
 * measured at the last few doublings before that. */
MUST_CHECK bool adaptive_pass(Adaptive *adaptive, Renderer *renderer, uint64_t samples, bool (*stop)(void),
                              Error *error);

/* The estimated relRMSE, percent; INFINITY while it is not known. */
double adaptive_percent(const Adaptive *adaptive);
