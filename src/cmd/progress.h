/* Shows the progress of a rendering on standard error: a line on a terminal that is written over, a line
 * every 5 seconds elsewhere, or JSON lines. */
#pragma once

#include "cmd/options.h"
#include "error/promise.h"
#include "render/chance.h"

#include <stdint.h>

typedef enum ProgressKind { PROGRESS_NONE, PROGRESS_TTY, PROGRESS_LINES, PROGRESS_JSON } ProgressKind;

typedef struct Progress {
    ProgressKind kind;
    /* The time of the last report, in seconds of clock_seconds(). */
    double last;
    /* Whether there is an unfinished line on the terminal. */
    bool line;
} Progress;

/* The figures of one report. */
typedef struct ProgressFigures {
    /* The mean over the pixels. */
    double samples;
    /* 0 if something else limits the picture. */
    uint64_t target_samples;
    uint64_t paths;
    /* Paths from the sun (render/photon_pass.h). */
    double light_paths;
    /* The estimated error in each measure (error/noise.h), and the part of it that is noise; infinite while
     * they are not known. The rest is the sky's bias. */
    double error[NOISE_MEASURES], noise[NOISE_MEASURES];
    ErrorTarget target;
    /* The noise at which noise and bias together reach the target. */
    double target_noise;
    /* The target is 0 if something else limits the picture. */
    double seconds, target_seconds;
    double startup_seconds;
    /* Samples, and points of light of paths from the sun or of Markov chains, that were left out. */
    uint64_t rejected, light_rejected;
    /* All are 0 if the scene does not search. */
    double search_rays, search_steps, search_broken, search_cut;
    bool done, interrupted;
    /* Whether some of the sun's light is found only by luck. Then the error leaves out light that no sample
     * has found. */
    bool sun_by_chance;
    /* How much light is left to chance, if that was counted. */
    ChanceShares chance;
    /* Of a finished picture with a target. */
    const Promise *promise;
} ProgressFigures;

Progress progress_start(const Options *options);

/* Whether it is time for a report, which then counts as made: ten times a second, or every 5 seconds in
 * lines. */
bool progress_due(Progress *progress);

/* Shows words, cut to the terminal's width; for the kinds that show words. */
void progress_words(Progress *progress, const char *words);

/* The same, at once, and on a terminal alone: for what may take a moment or a minute. */
void progress_begin(Progress *progress, const char *words);

/* Clears the unfinished line on the terminal, if there is one. */
void progress_clear(Progress *progress);

/* Reports the share of the sky's tables that are ready, if it is time and they have taken half a second
 * already. */
void progress_prepare(Progress *progress, double share, double seconds);

/* Reports if it is time. When done, the line is cleared, and the last JSON line is written. */
void progress_report(Progress *progress, const ProgressFigures *figures);
