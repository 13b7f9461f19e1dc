/* Text in a plot. */
#pragma once

#include <cairo.h>
#include <stdbool.h>

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
