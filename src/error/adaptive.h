/* Adaptive sampling. The next samples go to the tiles where they reduce the picture's error most, until the
 * error is below the target.
 *
 * Every round doubles the samples of some tiles. A doubling is worth (squared error that it removes) /
 * (samples that it takes). The plan is a level of this worth. If every tile is doubled as often as its
 * doublings are worth at least the level, the whole picture reaches the target exactly. Each tile that the
 * plan doubles at least once is doubled in this round. In levels, the tiles have a limit of their own too.
 *
 * The number of a pixel's samples depends on what its tile looked like, which biases the pixel's mean. Tiles
 * of 256 pixels make this bias smaller than can be measured (README.md). */
#pragma once

#include "error/evidence.h"
#include "error/noise.h"
#include "render/renderer.h"

typedef struct Adaptive {
    Noise noise;
    /* The measure in which the target is. */
    NoiseMeasure measure;
    Evidence evidence;
    /* Whether the samples suffice for a figure of the error. */
    bool claimed;
    /* The samples that each tile is still to get in this round. */
    uint64_t *wanted;
    Rectangle *regions;
    /* The light paths that are still to be traced in this round. */
    double wanted_light;
    /* No group of samples is begun after this time of clock_seconds(). INFINITY at first. */
    double deadline;
    /* Paths so far, over all pixels. */
    uint64_t paths;
    /* The least and the largest number of samples of a pixel. */
    uint64_t least, most;
    int rounds;
    /* Asked between groups of samples; NULL if nobody asks. When it returns true, a round ends before its
     * samples are complete: it is under way. The next call goes on with it, as if nothing had been in
     * between. */
    bool (*pause)(void);
    bool under_way;
    /* The samples of each pixel that a round under way brings all tiles to; 0 if it doubles tiles. */
    uint64_t even;
    /* Whether the round has a plan, and the paths and light paths before it. */
    bool chosen;
    uint64_t paths_before;
    double light_before;
    /* The samples of a pixel, on average, with which the plan reaches the target. */
    double planned;
    /* How many of the last rounds planned more than ADAPTIVE_MOST_SAMPLES, and how many found no tile to
     * double although the error was known and too large. */
    int beyond, aimless;
    /* Whether the last round added nothing although it was not stopped. */
    bool idle;
    /* The share of the picture's samples that were left out, because they were not finite or too large to be
     * summed. */
    double rejected;
} Adaptive;

/* Why more rounds would not help. */
typedef enum AdaptiveEnd {
    ADAPTIVE_GOES_ON,
    /* No path has found any light in 2^20 paths. */
    ADAPTIVE_BLACK,
    /* Two plans in turn, made after 256 samples of a pixel or more, were beyond ADAPTIVE_MOST_SAMPLES. */
    ADAPTIVE_BEYOND,
    /* All tiles that need more samples have as many as a film can count. */
    ADAPTIVE_FULL,
    /* The noise is known to no use: it is too large for a number, or no doubling makes it less. */
    ADAPTIVE_AIMLESS
} AdaptiveEnd;

/* A picture whose plan takes more samples of a pixel, on average, is given up. No pixel gets more than eight
 * times as many, because a film counts up to 2^24. */
#define ADAPTIVE_MOST_SAMPLES ((uint64_t)1 << 20)

/* Makes the state for `renderer`, whose film must be empty. Levels are measured if `tone` is not NULL. The
 * sun's own image is left out of all errors. */
Adaptive adaptive_create(const Renderer *renderer, NoiseMeasure measure, const ToneTable *tone);
void adaptive_destroy(Adaptive *adaptive);

/* Renders one round toward an estimated error of `target`. The first rounds sample the whole picture, the
 * later ones the tiles of the plan. `stop` is as for renderer_pass(), and may be NULL. */
MUST_CHECK bool adaptive_round(Adaptive *adaptive, Renderer *renderer, double target, bool (*stop)(void),
                               Error *error);

/* Ends a round that is under way: measures the picture that there is. */
MUST_CHECK bool adaptive_settle(Adaptive *adaptive, const Renderer *renderer, Error *error);

/* Saves the state of a picture, or loads it into one that was just begun with the same parameters. Without
 * the pointers and the deadline, it is all that the next round depends on. */
void adaptive_archive(Adaptive *adaptive, Archive *archive);

/* Renders one group of samples for all pixels, on the way to `samples` samples of each. The film must have
 * fewer. The noise is measured at the last few doublings only. */
MUST_CHECK bool adaptive_pass(Adaptive *adaptive, Renderer *renderer, uint64_t samples, bool (*stop)(void),
                              Error *error);

/* Returns the estimated error in a measure (error/noise.h), or INFINITY while it is not known. */
double adaptive_error(const Adaptive *adaptive, NoiseMeasure measure);

/* Whether and why the target is out of reach. */
AdaptiveEnd adaptive_end(const Adaptive *adaptive);
