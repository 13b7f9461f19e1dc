/* Adaptive sampling. The next samples go to the tiles where they reduce the picture's error most, until the
 * error is below the target.
 *
 * Every round doubles the samples of some tiles. A doubling is worth (squared error that it removes) /
 * (samples that it takes). The plan is a level of this worth. If every tile is doubled as often as its
 * doublings are worth at least the level, the whole picture reaches the target exactly. Each tile that the
 * plan doubles at least once is doubled in this round.
 *
 * The number of a pixel's samples depends on what its tile looked like, which biases the pixel's mean. Tiles
 * of 256 pixels make this bias smaller than can be measured (README.md). */
#pragma once

#include "error/noise.h"
#include "render/renderer.h"

typedef struct Adaptive {
    Noise noise;
    /* The samples that each tile is still to get in this round. */
    uint64_t *wanted;
    Rectangle *regions;
    /* No group of samples is begun after this time of clock_seconds(). INFINITY at first. */
    double deadline;
    /* Paths so far, over all pixels. */
    uint64_t paths;
    /* The least and the largest number of samples of a pixel. */
    uint64_t least, most;
    int rounds;
} Adaptive;

/* Makes the state for `renderer`, whose film must be empty. `trim` is as for noise_create(). */
Adaptive adaptive_create(const Renderer *renderer, double trim);
void adaptive_destroy(Adaptive *adaptive);

/* Renders one round toward an estimated relRMSE of `percent`. The first rounds sample the whole picture, the
 * later ones the tiles of the plan. `stop` is as for renderer_pass(), and may be NULL. */
MUST_CHECK bool adaptive_round(Adaptive *adaptive, Renderer *renderer, double percent, bool (*stop)(void),
                               Error *error);

/* Renders one group of samples for all pixels, on the way to `samples` samples of each. The film must have
 * fewer. The noise is measured at the last few doublings only. */
MUST_CHECK bool adaptive_pass(Adaptive *adaptive, Renderer *renderer, uint64_t samples, bool (*stop)(void),
                              Error *error);

/* Returns the estimated relRMSE in percent, or INFINITY while it is not known. */
double adaptive_percent(const Adaptive *adaptive);
