/* Estimates the error of a pane's picture while it converges. Each step takes a part of a frame's time, so
 * that a hand that moves again does not wait for all of it. */
#pragma once

#include "error/evidence.h"
#include "render/renderer.h"

typedef enum EstimateStage {
    ESTIMATE_DONE,
    ESTIMATE_FILM,
    ESTIMATE_CHANCE,
    ESTIMATE_EVIDENCE,
    ESTIMATE_NOISE
} EstimateStage;

typedef struct Estimate {
    /* The next step. While it is not ESTIMATE_DONE, the film must not change. */
    EstimateStage stage;
    /* What the steps before have read, until the last one. */
    Image picture;
    ChanceMap chance;
    /* The noise of the picture. */
    Noise noise;
    /* The estimated error. NaN while it is not known. */
    double error_percent;
    /* The same in 8-bit levels of the picture as it is shown, and in its worst tile. */
    double error_levels, worst_levels;
    /* The share of the picture's light that is left to chance (render/chance.h). 0 if that is not worth a
     * word. */
    double chance_percent;
    /* The mean radiance over pixels and channels. 0 while it is not known. */
    double mean;
} Estimate;

/* Begins for a new picture. The mean of the last one stays until it is known anew. */
void estimate_reset(Estimate *estimate);
void estimate_destroy(Estimate *estimate);

/* The film has more samples. It is measured whenever they have doubled, which takes some steps. */
void estimate_begin(Estimate *estimate, const Renderer *renderer, double exposure_ev);

/* Does the next step, if there is one. */
MUST_CHECK bool estimate_step(Estimate *estimate, const Renderer *renderer, Error *error);
