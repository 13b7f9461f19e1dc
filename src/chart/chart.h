/* The three charts. Each is measured on this machine, written into a CSV, and drawn from the CSV:
 *
 *   chart_paths  seconds against the error of a scene's picture, for sky, light and sequence methods
 *   chart_sky    nanoseconds of a sky's lookup against the error of its radiance; under an air with further
 *                orders also seconds to fill their tables against that error
 *   chart_scale  seconds against pixels, samples, depth and the number of shapes
 */
#pragma once

#include "chart/monitor.h"
#include "chart/points.h"
#include "error/promise.h"

typedef struct ChartParams {
    const Context *context;
    /* The picture. The charts choose its methods, seed and samples. */
    RenderParams picture;
    /* The folder for the results. It exists. */
    const char *folder;
    /* Lines that start with #. A chart adds lines of its own behind them. */
    const char *identity;
    /* About how long to measure. A chart that is complete already takes no time. */
    double seconds;
    /* The choice of auto is marked at this error, and errors of pictures are drawn in its measure. */
    ErrorTarget target;
    /* What other programs reached, for the chart of paths; NULL if nothing is known. */
    const Points *points;
    Monitor monitor;
    /* Gets the findings, and the names of files that were set aside, a line each. */
    Text *said;
} ChartParams;

/* The name of the first chart's files if its errors are in levels; otherwise it is "paths". */
#define CHART_PATHS_LEVELS "paths-levels"

/* If the monitor stops a chart, the rows so far stay in the CSV, and nothing is drawn. */
MUST_CHECK bool chart_paths(const ChartParams *params, Error *error);
MUST_CHECK bool chart_sky(const ChartParams *params, Error *error);
MUST_CHECK bool chart_scale(const ChartParams *params, Error *error);

/* Returns "FOLDER/NAME", to be freed. */
char *chart_path(const ChartParams *params, const char *name);

/* Prints the picture in words for titles: "512x512, sun at 30". */
void chart_describe(const ChartParams *params, Text *out);
