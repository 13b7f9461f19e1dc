/* Seconds of rendering, as a quiet machine would take them: the quickest of several passes of the same size.
 * Other programs only ever make a pass slower. Where things are to be compared, time them in turns, so that a
 * busy minute slows all of them. */
#pragma once

#include "render/renderer.h"

enum { STOPWATCH_SIZES = 8 };

typedef struct Stopwatch {
    double best[STOPWATCH_SIZES]; /* of a pass of 1, 2, 4, ... samples, up to the renderer's group */
    double spent;                 /* seconds of timing */
} Stopwatch;

/* Renders once and forgets it: the driver compiles at the first draw. */
MUST_CHECK bool stopwatch_start(Stopwatch *monitor, Renderer *renderer, Error *error);

/* Times a pass of whole groups, begun anew. */
MUST_CHECK bool stopwatch_group(Stopwatch *monitor, Renderer *renderer, Error *error);

/* Times each size once. */
MUST_CHECK bool stopwatch_sizes(Stopwatch *monitor, Renderer *renderer, Error *error);

/* What `samples` a pixel take, a power of 2: a pass, or as many groups as they are. */
double stopwatch_seconds(const Stopwatch *monitor, const Renderer *renderer, uint64_t samples);
