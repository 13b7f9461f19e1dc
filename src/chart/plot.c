#include "chart/plot.h"

#include <stdarg.h>
#include <stdio.h>

PlotSeries *plot_add_series(PlotPanel *panel, int color, PlotMarker marker, PlotLine line, const char *format,
                            ...) {
    if (panel->series_count < PLOT_SERIES) panel->series_count++;
    PlotSeries *series = &panel->series[panel->series_count - 1];
    *series = (PlotSeries){.color = color % PLOT_COLORS, .marker = marker, .line = line};
    va_list list;
    va_start(list, format);
    vsnprintf(series->label, sizeof series->label, format, list);
    va_end(list);
    return series;
}

void plot_add_point(PlotSeries *series, double x, double y) {
    if (series->count < PLOT_POINTS && x > 0 && y > 0)
        series->points[series->count++] = (PlotPoint){.x = x, .y = y};
}

void plot_add_note(PlotPanel *panel, const char *format, ...) {
    if (panel->note_count == PLOT_NOTES) return;
    va_list list;
    va_start(list, format);
    vsnprintf(panel->notes[panel->note_count], sizeof panel->notes[0], format, list);
    va_end(list);
    panel->note_count++;
}
