#include "base/memory.h"
#include "chart/chart_paths.h"
#include "chart/plot_write.h"
#include "choice/method.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

double paths_noise(const Paths *paths) {
    return paths->reference.noise[paths->params->target.measure];
}

bool paths_in_levels(const Paths *paths) {
    return paths->params->target.measure == NOISE_LEVELS;
}

static const char *unit(const Paths *paths) {
    return paths_in_levels(paths) ? "levels" : "%";
}

static ParetoCurve points_of(const Drawn *drawn) {
    return (ParetoCurve){drawn->points, drawn->count};
}

static void draw_front(const Paths *paths, PlotPanel *panel) {
    ParetoCurve curves[MOST_CURVES];
    ParetoPoint front[PLOT_POINTS];
    for (int i = 0; i < paths->count; i++) curves[i] = points_of(&paths->curves[i]);
    panel->front_count = pareto_front(curves, paths->count, front, PLOT_POINTS);
    for (int i = 0; i < panel->front_count; i++)
        panel->front[i] = (PlotPoint){.x = front[i].seconds, .y = front[i].percent};
}

static void draw_curve(PlotPanel *panel, const Drawn *curve, const char *label) {
    PlotSeries *series = plot_add_series(panel, curve->color, curve->marker, curve->line, "%s", label);
    for (int i = 0; i < curve->count; i++)
        plot_add_point(series, curve->points[i].seconds, curve->points[i].percent);
}

/* Draws the points of other programs. The front is that of the curves alone. */
static void draw_programs(const Points *points, PlotPanel *panel) {
    static const PlotMarker markers[] = {PLOT_TRIANGLE, PLOT_SQUARE, PLOT_DIAMOND, PLOT_DOT};
    for (int i = 0; i < points->count; i++) {
        const ProgramPoints *program = &points->programs[i];
        PlotSeries *series =
            plot_add_series(panel, PLOT_COLORS - 1, markers[i % 4], PLOT_DOTTED, "%s", program->name);
        for (int k = 0; k < program->count; k++)
            plot_add_point(series, program->points[k].seconds, program->points[k].percent);
    }
}

static void draw_panel(const Paths *paths, Plot *plot, int which, const char *title) {
    PlotPanel *panel = &plot->panels[plot->panel_count];
    snprintf(panel->title, sizeof panel->title, "%s", title);
    snprintf(panel->x_label, sizeof panel->x_label, "seconds of rendering");
    snprintf(panel->y_label, sizeof panel->y_label, "%s, %s", paths_in_levels(paths) ? "RMS" : "relRMSE",
             unit(paths));
    for (int i = 0; i < paths->count; i++) {
        const Drawn *curve = &paths->curves[i];
        char label[112];
        if (!(curve->panels & which)) continue;
        if (which == PANEL_LIGHTS) {
            bool plain = strcmp(curve->curve.row.words[2], method_family(METHOD_SEQUENCE)->fallback) == 0;
            const char *disk = curve->combination.disk;
            snprintf(label, sizeof label, "%s, %s%s%s", curve->curve.row.words[1],
                     curve->curve.row.words[plain ? 3 : 2], disk ? ", sun " : "", disk ? disk : "");
        } else {
            snprintf(label, sizeof label, "%s", curve->curve.row.words[0]);
        }
        draw_curve(panel, curve, label);
    }
    if (which == PANEL_LIGHTS && paths->params->points) draw_programs(paths->params->points, panel);
    draw_front(paths, panel);
    plot->panel_count += panel->series_count > 0;
}

/* Returns the time at which the first of the curves reaches the error, and sets `first` to that curve. */
static double first_at(const Paths *paths, double percent, const Drawn **first) {
    double least = INFINITY;
    for (int i = 0; i < paths->count; i++) {
        ParetoCurve curve = points_of(&paths->curves[i]);
        double seconds = pareto_seconds(&curve, percent);
        if (seconds < least) least = seconds, *first = &paths->curves[i];
    }
    return least;
}

static void print_methods(const Drawn *drawn, Text *out) {
    for (int i = 0; i < CURVE_WORDS; i++) text_print(out, "%s%s", i ? " " : "", drawn->curve.row.words[i]);
}

static void say_auto(const Paths *paths, const Drawn *automatic, const Drawn *first, double percent,
                     double seconds, double least) {
    Text *said = paths->params->said;
    text_print(said, "auto, ");
    print_methods(automatic, said);
    text_print(said, ": %.3g %s%s in %.3g s, %.2f times the quickest, ", percent, unit(paths),
               percent > paths->params->target.amount ? ", the least measured," : "", seconds,
               seconds / least);
    print_methods(first, said);
    text_print(said, "\n");
}

/* Draws a ring where auto's curve reaches the target error, or at the curve's end. Says how far this point is
 * from the front. */
static void mark_auto(const Paths *paths, Plot *plot) {
    const Drawn *automatic = &paths->curves[0], *first = automatic;
    double percent = paths->params->target.amount;
    if (!automatic->count) return;
    ParetoCurve curve = points_of(automatic);
    if (!(pareto_seconds(&curve, percent) < INFINITY)) percent = curve.points[curve.count - 1].percent;
    double seconds = pareto_seconds(&curve, percent);
    double least = first_at(paths, percent, &first);
    say_auto(paths, automatic, first, percent, seconds, least);
    for (int i = 0; i < plot->panel_count; i++) {
        PlotPanel *panel = &plot->panels[i];
        panel->ring = (PlotPoint){.x = seconds, .y = percent};
        snprintf(panel->ring_label, sizeof panel->ring_label, "auto: %.2g %s in %.2g s", percent, unit(paths),
                 seconds);
    }
}

bool paths_draw(const Paths *paths, Error *error) {
    const ChartParams *params = paths->params;
    Plot *plot = memory_get(1, sizeof *plot);
    Text words = {0};
    chart_describe(params, &words);
    snprintf(plot->title, sizeof plot->title, "Speed against accuracy: %s", text_string(&words));
    snprintf(plot->subtitle, sizeof plot->subtitle,
             "%s against a converged picture (its own noise %.2g %s); %s",
             paths_in_levels(paths) ? "RMS of the picture as it is shown" : "relRMSE", paths_noise(paths),
             unit(paths), params->context->renderer);
    plot->same_axes = true;
    char lights[96];
    snprintf(lights, sizeof lights, "Light, sampling, sequence; %s", paths->curves[0].curve.row.words[0]);
    draw_panel(paths, plot, PANEL_LIGHTS, lights);
    draw_panel(paths, plot, PANEL_SKIES, "Skies, by cosine, evenly");
    mark_auto(paths, plot);
    char *path = chart_path(params, paths_in_levels(paths) ? CHART_PATHS_LEVELS : "paths");
    bool ok = plot_write(plot, path, error);
    free(path);
    text_free(&words);
    free(plot);
    return ok;
}
