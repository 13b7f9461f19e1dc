/* A logarithmic axis. Its range comes from the values that it shows. A zeroed axis is empty. */
#pragma once

#include <stdbool.h>

enum { PLOT_TICKS = 128 };

typedef struct PlotAxis {
    /* Both are 0 while the axis is empty. */
    double low, high;
} PlotAxis;

typedef struct PlotTick {
    double value;
    /* Whether the value is a power of ten. */
    bool strong;
    /* May be empty. */
    char label[16];
} PlotTick;

/* Widens the range to include a value. A value that is not finite or not above 0 is ignored. */
void plot_axis_include(PlotAxis *axis, double value);

/* Widens the range, with some room, to ends that are 1, 2 or 5 times a power of ten. An empty axis gets the
 * range from 1 to 10. */
void plot_axis_finish(PlotAxis *axis);

/* Returns the place of a value on the axis, from 0 at the low end to 1 at the high end. */
double plot_axis_at(const PlotAxis *axis, double value);

/* Lists the ticks in rising order, and returns their number. */
int plot_axis_ticks(const PlotAxis *axis, PlotTick ticks[PLOT_TICKS]);
