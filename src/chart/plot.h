/* Charts with logarithmic axes: panels side by side, drawn once for SVG and PNG. */
#pragma once

#include "base/text.h"

enum { PLOT_POINTS = 48, PLOT_SERIES = 12, PLOT_PANELS = 4, PLOT_NOTES = 4, PLOT_COLORS = 7 };

typedef struct PlotPoint {
    double x, y;    /* above 0, or the point is left out */
    double high;    /* the end of a whisker upward; 0 for none */
    char label[16]; /* beside the point; may be empty */
} PlotPoint;

typedef enum PlotMarker { PLOT_DOT, PLOT_SQUARE, PLOT_TRIANGLE, PLOT_DIAMOND } PlotMarker;
typedef enum PlotLine { PLOT_SOLID, PLOT_DASHED, PLOT_DOTTED, PLOT_NO_LINE } PlotLine;

typedef struct PlotSeries {
    char label[64]; /* in the legend */
    int color;      /* 0 .. PLOT_COLORS - 1, told apart by colour-blind eyes too */
    PlotMarker marker;
    PlotLine line;
    PlotPoint points[PLOT_POINTS];
    int count;
} PlotSeries;

typedef struct PlotPanel {
    char title[96], x_label[64], y_label[64];
    PlotSeries series[PLOT_SERIES];
    int series_count;
    PlotPoint front[PLOT_POINTS]; /* a halo behind the series */
    int front_count;
    PlotPoint ring; /* x 0 for none */
    char ring_label[64];
    char notes[PLOT_NOTES][96]; /* lines within the panel, under the legend */
    int note_count;
} PlotPanel;

typedef struct Plot {
    char title[128], subtitle[256];
    PlotPanel panels[PLOT_PANELS];
    int panel_count;
    bool same_axes; /* for all panels */
} Plot;

/* The next series of a panel, zeroed; the last one again where there is no room. */
PlotSeries *plot_add_series(PlotPanel *panel, int color, PlotMarker marker, PlotLine line, const char *format,
                            ...) __attribute__((format(printf, 5, 6)));

/* Drops the point where there is no room. */
void plot_add_point(PlotSeries *series, double x, double y);
void plot_add_note(PlotPanel *panel, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Replaces PATH.svg and PATH.png (800 units wide, the PNG at two pixels a unit). STATUS_OUTPUT. */
MUST_CHECK bool plot_write(const Plot *plot, const char *path, Error *error);
