/* How far a rendering is: a line on a terminal, or JSON lines, on standard error. */
#pragma once

#include "cmd/options.h"
#include "gl/film.h"

#include <stdint.h>

typedef enum ProgressKind { PROGRESS_NONE, PROGRESS_TTY, PROGRESS_JSON } ProgressKind;

typedef struct Progress {
    ProgressKind kind;
    double last; /* seconds at the last report */
    bool line;   /* an unfinished line stands on the terminal */
} Progress;

/* One report's figures; times in seconds. */
typedef struct ProgressFigures {
    double samples;          /* mean of the pixels' */
    uint64_t target_samples; /* 0 if something else limits */
    uint64_t paths;
    double noise_percent; /* of error_percent, and its goal; the rest is the sky's bias */
    double target_noise_percent;
    double error_percent,
        target_error_percent;       /* estimated relRMSE, infinite while it is not known; target 0 is none */
    double seconds, target_seconds; /* target 0 if something else limits */
    double startup_seconds;
    uint64_t rejected;
    double search_rays, search_steps, search_broken, search_cut; /* all 0 where the scene does not search */
    bool done, interrupted;
    /* Whether some of the sun's light is found by chance: then the error leaves out what no sample has found.
     */
    bool sun_by_chance;
    /* How much, where it was counted. */
    FilmChance chance;
} ProgressFigures;

Progress progress_start(const Options *options);

/* Reports at most ten times a second, and always when done. */
void progress_report(Progress *progress, const ProgressFigures *figures);
