/* Whether the error that was asked for is promised of a finished picture, and why not. */
#pragma once

#include "error/adaptive.h"

/* The error that a picture is to have, in a measure (error/noise.h). `amount` is 0 if none was asked for. */
typedef struct ErrorTarget {
    NoiseMeasure measure;
    double amount;
} ErrorTarget;

/* The relRMSE, percent, for which methods are chosen so that their bias suits the target. */
double target_percent(ErrorTarget target, Tone tone);

/* How the picture ended, besides what Adaptive knows. */
typedef struct PromiseTerms {
    ErrorTarget target;
    /* Whether the estimated noise left room for the bias. */
    bool reached;
    /* The sky's bias in the measure; NAN if it is not known. */
    double bias;
    bool interrupted;
    /* The names of the scene's materials. */
    const SceneFacts *facts;
} PromiseTerms;

typedef struct Promise {
    bool given;
    /* Why it is not given, as a sentence without its end; empty if it is. */
    char reason[320];
    /* The share of the pixels that the reason is about; 0 if it is about no pixels. */
    double pixels;
} Promise;

Promise promise_judge(const Adaptive *adaptive, const PromiseTerms *terms);
