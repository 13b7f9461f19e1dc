/* The chart of the light methods' curves: what is measured (chart_paths.c) and how it is drawn
 * (chart_paths_draw.c). */
#pragma once

#include "chart/chart.h"
#include "chart/curve.h"
#include "chart/plot.h"

enum {
    MOST_CURVES = 24,
    /* The panels, as bits. */
    PANEL_LIGHTS = 1,
    PANEL_SKIES = 2
};

/* A curve as it is drawn. */
typedef struct Drawn {
    Combination combination;
    /* The panels that show the curve. */
    int panels;
    int color;
    PlotMarker marker;
    PlotLine line;
    Curve curve;
    ParetoPoint points[CURVE_MOST_POINTS];
    int count;
} Drawn;

typedef struct Paths {
    const ChartParams *params;
    Drawn curves[MOST_CURVES];
    int count;
    Reference reference;
    Ledger ledger;
} Paths;

/* Whether errors are in levels. */
bool paths_in_levels(const Paths *paths);

/* Returns the reference's noise, measured in the same way as the errors of the curves. */
double paths_noise(const Paths *paths);

/* Writes the chart's files. */
MUST_CHECK bool paths_draw(const Paths *paths, Error *error);
