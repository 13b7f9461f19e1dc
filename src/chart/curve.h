/* Error against time of one combination of methods: a curve of rows, at 1, 2, 4, ... samples a pixel, or
 * where adaptive sampling believes to be at 16, 8, 4, ... percent. */
#pragma once

#include "chart/ledger.h"
#include "chart/pareto.h"
#include "chart/reference.h"
#include "chart/stopwatch.h"

#define CURVE_COLUMNS "sky,light,sequence,sampling,samples,seconds,relrmse_percent,last"
enum { CURVE_WORDS = 4, CURVE_MOST_POINTS = 32, CURVE_MOST_ROUNDS = 64 };

/* NULL is auto. */
typedef struct Combination {
    const char *sky, *light, *sequence;
    bool adaptive; /* as `render` samples; else each pixel alike */
} Combination;

typedef struct CurveLimits {
    double seconds;       /* no point is later */
    double least_percent; /* nor any after the first that is below */
} CurveLimits;

/* What a run of adaptive sampling finds on its way down. All runs are the same to the bit, so that the first
 * is judged and each round has its quickest time. */
typedef struct Goals {
    LedgerRow rows[CURVE_MOST_POINTS]; /* where a goal took a round or more */
    int rounds[CURVE_MOST_POINTS];     /* by then */
    int count;
    double best[CURVE_MOST_ROUNDS]; /* seconds of each round */
    int round_count;
} Goals;

/* A curve that is still to be measured. A zeroed one is closed. */
typedef struct Curve {
    LedgerRow row; /* its words: the methods in full */
    bool open, adaptive;
    bool trimmed; /* judged without the 0.1 % worst pixels, as the sun itself is in the picture */
    Renderer renderer;
    Stopwatch stopwatch; /* if it is even */
    Goals goals;         /* if it is adaptive */
    double spent;        /* seconds of timing */
} Curve;

/* Fills in the row. Closed if the ledger has the curve up to its last row, by whatever limits; else compiled,
 * and what the ledger has of it dropped. */
MUST_CHECK bool curve_open(Curve *curve, const Combination *combination, const Context *context,
                           const RenderParams *params, Ledger *ledger, Error *error);
void curve_close(Curve *curve);

/* Times an open curve once more: to be called in turns with others', once at least. */
MUST_CHECK bool curve_time(Curve *curve, const Reference *reference, const CurveLimits *limits,
                           const Monitor *monitor, Error *error);

/* Renders and judges the points of an open curve that was timed, into the ledger. Stopped by the monitor it
 * leaves what it has. */
MUST_CHECK bool curve_measure(Curve *curve, const Reference *reference, const CurveLimits *limits,
                              const Monitor *monitor, Ledger *ledger, Error *error);

/* A curve's points in the order of their samples, those without an error left out; gives their number. */
int curve_points(const Ledger *ledger, const LedgerRow *row, ParetoPoint points[CURVE_MOST_POINTS]);
