/* Measures what a term of the model is worth in a scene: how much it changes the picture, and what it costs.
 */
#pragma once

#include "chart/stopwatch.h"
#include "chart/term.h"

typedef struct Worth {
    TermState state;
    /* The relRMSE between the pictures with the term and without it, in percent. Noise is not part of it.
     * Below `change_known` the change cannot be told from 0. */
    double change_percent, change_known;
    /* (time of a sample with the term) / (time of one without it) - 1. */
    double cost_percent;
    /* (seconds in which all tables are filled with the term) - (those without it). They are spent once,
     * before the first sample. Other programs on the machine lengthen them. */
    double once_seconds;
    /* For terms that leave the picture's mean as it is: (time without the term) / (time with it), both to the
     * same noise. */
    double gain;
} Worth;

/* The picture as it is, rendered with two seeds. */
typedef struct WorthBase {
    const RenderParams *params;
    const Context *context;
    Renderer renderer;
    Stopwatch stopwatch;
    /* How often its tables were filled to be timed. */
    int steps;
    Image pictures[2];
    unsigned samples;
} WorthBase;

MUST_CHECK bool worth_begin(WorthBase *base, const Context *context, const RenderParams *params,
                            unsigned samples, bool (*stop)(void), Error *error);
void worth_end(WorthBase *base);

/* Renders the picture with the term turned the other way and the same random numbers, and times both pictures
 * in alternation. A term in the state TERM_NONE takes no time. */
MUST_CHECK bool worth_of(WorthBase *base, const Term *term, bool (*stop)(void), Worth *worth, Error *error);
