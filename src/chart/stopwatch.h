/* Measures rendering time as on a quiet machine: it takes the quickest of several passes of the same size,
 * because other programs can only make a pass slower. To compare methods, time them in alternation, so that a
 * busy minute slows all of them. */
#pragma once

#include "render/renderer.h"

enum { STOPWATCH_SIZES = 8 };

typedef struct Stopwatch {
    /* The least seconds of a pass of 1, 2, 4, ... samples, up to the renderer's group. */
    double best[STOPWATCH_SIZES];
    /* Seconds of timing so far. */
    double spent;
} Stopwatch;

/* Renders once and forgets the picture, because the driver compiles the shader at the first draw. */
MUST_CHECK bool stopwatch_start(Stopwatch *monitor, Renderer *renderer, Error *error);

/* Times one pass of a whole group, from an empty film. */
MUST_CHECK bool stopwatch_group(Stopwatch *monitor, Renderer *renderer, Error *error);

/* Times a pass of each size once. */
MUST_CHECK bool stopwatch_sizes(Stopwatch *monitor, Renderer *renderer, Error *error);

/* Returns the seconds that `samples` samples a pixel take, as one pass or as several groups. `samples` is a
 * power of 2. */
double stopwatch_seconds(const Stopwatch *monitor, const Renderer *renderer, uint64_t samples);
