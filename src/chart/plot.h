/* Charts with logarithmic axes: panels side by side, as SVG and PNG. */
#pragma once

#include "base/text.h"

enum { PLOT_POINTS = 48, PLOT_SERIES = 16, PLOT_PANELS = 4, PLOT_NOTES = 4, PLOT_COLORS = 7 };

typedef struct PlotPoint {
    /* A point is left out unless both are above 0. */
    double x, y;
    /* The upper end of a whisker. 0 means no whisker. */
    double high;
    /* Stands beside the point. May be empty. */
    char label[16];
} PlotPoint;

typedef enum PlotMarker { PLOT_DOT, PLOT_SQUARE, PLOT_TRIANGLE, PLOT_DIAMOND } PlotMarker;
typedef enum PlotLine { PLOT_SOLID, PLOT_DASHED, PLOT_DOTTED, PLOT_NO_LINE } PlotLine;

typedef struct PlotSeries {
    /* Stands in the legend. */
    char label[64];
    /* From 0 to PLOT_COLORS - 1. Colour-blind people can tell the colours apart. */
    int color;
    PlotMarker marker;
    PlotLine line;
    PlotPoint points[PLOT_POINTS];
    int count;
} PlotSeries;

typedef struct PlotPanel {
    char title[96], x_label[64], y_label[64];
    PlotSeries series[PLOT_SERIES];
    int series_count;
    /* Drawn as a pale band behind the series. */
    PlotPoint front[PLOT_POINTS];
    int front_count;
    /* A ring is drawn at this point. x is 0 if there is none. */
    PlotPoint ring;
    char ring_label[64];
    /* Lines of text within the panel, under the legend. */
    char notes[PLOT_NOTES][96];
    int note_count;
} PlotPanel;

typedef struct Plot {
    char title[128], subtitle[256];
    PlotPanel panels[PLOT_PANELS];
    int panel_count;
    /* Whether all panels have the same axes. */
    bool same_axes;
} Plot;

/* Returns the next series of a panel, zeroed. Returns the last series again if there is no room. */
PlotSeries *plot_add_series(PlotPanel *panel, int color, PlotMarker marker, PlotLine line, const char *format,
                            ...) __attribute__((format(printf, 5, 6)));

/* Adds a point. It is dropped if there is no room. */
void plot_add_point(PlotSeries *series, double x, double y);
void plot_add_note(PlotPanel *panel, const char *format, ...) __attribute__((format(printf, 2, 3)));
