/* One panel of a plot, drawn with cairo: axes, grid, series, legend. */
#pragma once

#include "chart/plot.h"
#include "chart/plot_axis.h"

#include <cairo.h>

typedef struct PlotText {
    double size;
    bool bold, grey;
    bool backed;  /* on a pale ground, so that lines behind it do not hide it */
    double align; /* 0: it starts at x, 0.5: x is its middle, 1: it ends there */
} PlotText;

/* On the baseline y. */
void plot_text(cairo_t *cairo, const char *text, double x, double y, const PlotText *style);
double plot_text_width(cairo_t *cairo, const char *text, const PlotText *style);

/* Widens the axes to what the panel shows. */
void plot_panel_include(const PlotPanel *panel, PlotAxis *across, PlotAxis *up);

typedef struct PlotPlace {
    double x, y, width, height; /* with the axes' labels */
    PlotAxis across, up;        /* finished */
} PlotPlace;

void plot_panel_draw(const PlotPanel *panel, cairo_t *cairo, const PlotPlace *place);
