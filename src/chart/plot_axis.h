/* A logarithmic axis: its range from what it shows, its ticks. A zeroed axis is empty. */
#pragma once

#include <stdbool.h>

enum { PLOT_TICKS = 128 };

typedef struct PlotAxis {
    double low, high; /* 0 while empty */
} PlotAxis;

typedef struct PlotTick {
    double value;
    bool strong;    /* a power of ten */
    char label[16]; /* may be empty */
} PlotTick;

/* Values that are not above 0, or not finite, are ignored. */
void plot_axis_include(PlotAxis *axis, double value);

/* Widens the range to 1, 2 or 5 times a power of ten with room to spare; an empty one to 1 .. 10. */
void plot_axis_finish(PlotAxis *axis);

/* From 0 at the low end to 1 at the high end. */
double plot_axis_at(const PlotAxis *axis, double value);

/* In rising order; gives their number. */
int plot_axis_ticks(const PlotAxis *axis, PlotTick ticks[PLOT_TICKS]);
