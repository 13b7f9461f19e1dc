#include "error/promise.h"

#include "error/noise_figures.h"
#include "render/chance.h"

#include <math.h>
#include <stdio.h>

double target_percent(ErrorTarget target, Tone tone) {
    return target.measure == NOISE_LEVELS ? target.amount / tone_levels_per_percent(tone) : target.amount;
}

/* The part of the squared error that is due to light that no sample has found. */
static double unmet_part(const Adaptive *adaptive) {
    const Noise *noise = &adaptive->noise;
    double unmet = 0, all = 0;
    for (int i = 0; i < noise->columns * noise->rows; i++) {
        const NoiseTile *tile = &noise->tiles[i];
        unmet += tile->change[adaptive->measure].unmet / (double)tile->samples;
        all += noise_of_tile(noise, tile, adaptive->measure, (double)tile->samples);
    }
    return all > 0 ? unmet / all : 0;
}

/* Prints "sunlight that is thrown by glass in 3 % of the pixels" behind `before`, and `after` behind that. */
static void say_thrown(const char *before, unsigned materials, double pixels, const char *after,
                       const SceneFacts *facts, Promise *promise) {
    char throwers[128];
    chance_throwers(materials, facts, throwers, sizeof throwers);
    promise->pixels = pixels;
    snprintf(promise->reason, sizeof promise->reason,
             "%ssunlight that is thrown by %s in %.2g %% of the pixels %s", before, throwers, 100 * pixels,
             after);
}

#define TOO_MANY "it would take more than 2^20 samples of a pixel, on average"

/* What the picture has not reached, by what ended it. */
static void say_unreached(const Adaptive *adaptive, const PromiseTerms *terms, Promise *promise) {
    const Evidence *evidence = &adaptive->evidence;
    AdaptiveEnd end = adaptive_end(adaptive);
    const char *reason = end == ADAPTIVE_BEYOND    ? TOO_MANY
                         : end == ADAPTIVE_FULL    ? "some pixels have as many samples as are counted, 2^23"
                         : end == ADAPTIVE_AIMLESS ? "more samples do not make its noise less"
                                                   : "the time was up";
    snprintf(promise->reason, sizeof promise->reason, "%s", reason);
    if (end == ADAPTIVE_BEYOND && evidence->thrown)
        say_thrown(TOO_MANY ": ", evidence->thrown, evidence->thrown_pixels, "is found by chance",
                   terms->facts, promise);
}

/* The part of its samples that a picture may lose. What a lost sample would have brought is not known, so the
 * picture is taken to miss as large a part of its light, or of the scale of levels. */
static double rejected_limit(ErrorTarget target) {
    return target.measure == NOISE_LEVELS ? target.amount / 255 : target.amount / 100;
}

Promise promise_judge(const Adaptive *adaptive, const PromiseTerms *terms) {
    const Evidence *evidence = &adaptive->evidence;
    Promise promise = {0};
    if (terms->interrupted && !terms->reached) {
        snprintf(promise.reason, sizeof promise.reason, "it was interrupted");
    } else if (adaptive->noise.largest <= 0) {
        snprintf(promise.reason, sizeof promise.reason, "no path has found any light");
        promise.pixels = 1;
    } else if (adaptive->rejected > rejected_limit(terms->target)) {
        snprintf(promise.reason, sizeof promise.reason,
                 "%.2g %% of the samples were not finite, or too large to be summed",
                 100 * adaptive->rejected);
    } else if (isnan(terms->bias)) {
        snprintf(promise.reason, sizeof promise.reason, "the sky's bias is not known here");
    } else if (terms->bias > terms->target.amount) {
        snprintf(promise.reason, sizeof promise.reason, "the sky alone may err by more, %.2g %s", terms->bias,
                 terms->target.measure == NOISE_LEVELS ? "levels" : "%");
    } else if (!terms->reached && evidence->unmet && unmet_part(adaptive) > 0.5) {
        say_thrown("", evidence->unmet, evidence->pixels, "was found by too few paths to know its noise",
                   terms->facts, &promise);
    } else if (!terms->reached) {
        say_unreached(adaptive, terms, &promise);
    } else {
        promise.given = true;
    }
    return promise;
}
