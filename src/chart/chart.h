/* The three charts, each measured on this machine into a CSV and drawn from it:
 *
 *   chart_paths  seconds against relRMSE of a scene's picture, for sky, light and sequence methods
 *   chart_sky    nanoseconds of a sky's lookup against the error of its radiance
 *   chart_scale  seconds against pixels, samples, depth and the number of shapes
 */
#pragma once

#include "chart/monitor.h"
#include "render/renderer.h"

typedef struct ChartParams {
    const Context *context;
    RenderParams
        picture; /* its methods, seed and samples are the charts' to choose, auto's error is that below */
    const char *folder;   /* there already */
    const char *identity; /* lines that start with #, before those that a chart adds */
    double seconds;       /* to measure in, about; charts that are there already take none */
    double error_percent; /* where auto's choice is marked */
    Monitor monitor;
    Text *said; /* findings, a line each; what was set aside, too */
} ChartParams;

/* A chart that the monitor stopped has its rows so far in the CSV, and draws nothing. */
MUST_CHECK bool chart_paths(const ChartParams *params, Error *error);
MUST_CHECK bool chart_sky(const ChartParams *params, Error *error);
MUST_CHECK bool chart_scale(const ChartParams *params, Error *error);

/* What the charts share: "FOLDER/NAME", to be freed; and "512x512, sun at 30", for titles. */
char *chart_path(const ChartParams *params, const char *name);
void chart_describe(const ChartParams *params, Text *out);
