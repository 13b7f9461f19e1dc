/* Where things are in a panel of a plot, and where there is room for a label. */
#pragma once

#include "chart/plot.h"
#include "chart/plot_axis.h"

#include <cairo.h>

typedef struct PlotBox {
    double x, y, width, height;
} PlotBox;

typedef struct PlotFrame {
    const PlotPanel *panel;
    cairo_t *cairo;
    PlotBox box;
    PlotAxis across, up;
    /* The boxes of labels that are drawn already. */
    PlotBox taken[PLOT_POINTS];
    int taken_count;
} PlotFrame;

/* Pixels of a value on the axes. */
double plot_frame_x(const PlotFrame *frame, double x);
double plot_frame_y(const PlotFrame *frame, double y);

/* Returns how much of the drawing a label in this box would hide. */
int plot_frame_crowd(const PlotFrame *frame, PlotBox box);

/* Keeps a place from the labels that follow. */
void plot_frame_take(PlotFrame *frame, PlotBox box);
