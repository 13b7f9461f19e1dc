/* What a term of the model is worth in a scene: the change that it makes in the picture, and what it costs.
 */
#pragma once

#include "chart/stopwatch.h"
#include "chart/term.h"

typedef struct Worth {
    TermState state;
    /* relRMSE, percent of the picture's mean, between the picture with the term and without it; what noise
     * would make of two equal pictures is not in it. Below `change_known` it cannot be told from 0. */
    double change_percent, change_known;
    double cost_percent; /* time with the term over time without it, less 1 */
    /* Of terms that leave the picture as it is: the time that it takes without the term to come to the same
     * noise, over the time with it. */
    double gain;
} Worth;

/* The picture as it is, by two seeds. */
typedef struct WorthBase {
    const RenderParams *params;
    const Context *context;
    Renderer renderer;
    Stopwatch stopwatch;
    Image pictures[2];
    unsigned samples;
} WorthBase;

MUST_CHECK bool worth_begin(WorthBase *base, const Context *context, const RenderParams *params,
                            unsigned samples, bool (*stop)(void), Error *error);
void worth_end(WorthBase *base);

/* Renders the picture with the term turned the other way, with the same random numbers, and times both in
 * turns. A TERM_NONE takes no time. */
MUST_CHECK bool worth_of(WorthBase *base, const Term *term, bool (*stop)(void), Worth *worth, Error *error);
