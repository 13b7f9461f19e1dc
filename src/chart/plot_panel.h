/* Draws one panel of a plot with cairo: axes, grid, series and legend. */
#pragma once

#include "chart/plot.h"
#include "chart/plot_axis.h"

#include <cairo.h>

/* Widens the axes to include all that the panel shows. */
void plot_panel_include(const PlotPanel *panel, PlotAxis *across, PlotAxis *up);

typedef struct PlotPlace {
    /* The place includes the labels of the axes. */
    double x, y, width, height;
    /* plot_axis_finish() was called for both. */
    PlotAxis across, up;
} PlotPlace;

void plot_panel_draw(const PlotPanel *panel, cairo_t *cairo, const PlotPlace *place);
