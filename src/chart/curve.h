/* Error against time of one combination of methods, as rows of a ledger.
 *
 * The points of an even curve are at 1, 2, 4, ... samples a pixel. The points of an adaptive curve are where
 * adaptive sampling estimates its error to be 16, 8, 4, ... percent, or levels. */
#pragma once

#include "chart/ledger.h"
#include "chart/pareto.h"
#include "chart/reference.h"
#include "chart/stopwatch.h"

#define CURVE_COLUMNS "sky,light,sequence,sampling,disk,samples,seconds,error,last"
enum { CURVE_WORDS = 5, CURVE_MOST_POINTS = 32, CURVE_MOST_ROUNDS = 64 };

/* The names of methods. NULL is auto. */
typedef struct Combination {
    const char *sky, *light, *sequence;
    /* Whether samples are distributed as `render` does it. If not, all pixels get the same number. */
    bool adaptive;
    /* The method of the sun's disk. NULL is the picture's. */
    const char *disk;
} Combination;

typedef struct CurveLimits {
    /* The curve has no point after this time. */
    double seconds;
    /* The curve ends at the first point below this error. */
    double least_error;
} CurveLimits;

/* The results of adaptive sampling. All runs are the same to the bit. The errors therefore come from the
 * first run alone, and each round has the time of its quickest run. */
typedef struct Goals {
    /* A row for each goal that took a round or more. */
    LedgerRow rows[CURVE_MOST_POINTS];
    /* The number of rounds until that goal. */
    int rounds[CURVE_MOST_POINTS];
    int count;
    /* The least seconds of each round. */
    double best[CURVE_MOST_ROUNDS];
    int round_count;
} Goals;

/* A curve that is still to be measured. A zeroed curve is closed. */
typedef struct Curve {
    /* Its words are the names of the methods in full. */
    LedgerRow row;
    bool open, adaptive;
    /* The measure of errors. */
    NoiseMeasure measure;
    /* How levels are shown. */
    double exposure_ev;
    Renderer renderer;
    /* Used by an even curve. */
    Stopwatch stopwatch;
    /* Used by an adaptive curve. */
    Goals goals;
    /* Seconds of timing so far. */
    double spent;
} Curve;

/* Sets the row's words. `params` and `measure` are of the picture and of its errors. If the ledger has the
 * curve up to its last row, by whatever limits, the curve stays closed. Otherwise its shader is compiled, and
 * the rows of it in the ledger are dropped. */
MUST_CHECK bool curve_open(Curve *curve, const Combination *combination, const Context *context,
                           const RenderParams *params, NoiseMeasure measure, Ledger *ledger, Error *error);
void curve_close(Curve *curve);

/* Times an open curve once more. Call it at least once, in alternation with other curves. */
MUST_CHECK bool curve_time(Curve *curve, const Reference *reference, const CurveLimits *limits,
                           const Monitor *monitor, Error *error);

/* Renders the points of an open curve that was timed, measures their errors, and adds them to the ledger. If
 * the monitor stops it, the points so far stay. */
MUST_CHECK bool curve_measure(Curve *curve, const Reference *reference, const CurveLimits *limits,
                              const Monitor *monitor, Ledger *ledger, Error *error);

/* Returns the number of a curve's points, in the order of their samples. Points without an error are left
 * out.
 */
int curve_points(const Ledger *ledger, const LedgerRow *row, ParetoPoint points[CURVE_MOST_POINTS]);
