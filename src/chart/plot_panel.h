/* Draws one panel of a plot with cairo: axes, grid, series and legend. */
#pragma once

#include "chart/plot.h"
#include "chart/plot_axis.h"

#include <cairo.h>

typedef struct PlotText {
    double size;
    bool bold, grey;
    /* Whether the text has a pale ground, so that it stays legible in front of lines. */
    bool backed;
    /* 0 if the text starts at x, 0.5 if x is its middle, 1 if it ends at x. */
    double align;
} PlotText;

/* Draws a text. y is its baseline. */
void plot_text(cairo_t *cairo, const char *text, double x, double y, const PlotText *style);
double plot_text_width(cairo_t *cairo, const char *text, const PlotText *style);

/* Widens the axes to include all that the panel shows. */
void plot_panel_include(const PlotPanel *panel, PlotAxis *across, PlotAxis *up);

typedef struct PlotPlace {
    /* The place includes the labels of the axes. */
    double x, y, width, height;
    /* plot_axis_finish() was called for both. */
    PlotAxis across, up;
} PlotPlace;

void plot_panel_draw(const PlotPanel *panel, cairo_t *cairo, const PlotPlace *place);
