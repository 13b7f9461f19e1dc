#include "base/memory.h"
#include "chart/chart.h"
#include "chart/field.h"
#include "chart/identity.h"
#include "chart/ledger.h"
#include "chart/plot_write.h"
#include "chart/slope.h"

#include "base/clock.h"
#include "base/file.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SAMPLES = 16, MOST_STEPS = 8 };

static const double turn_seconds = 0.1;

typedef enum What { PIXELS, SAMPLE_COUNT, DEPTH, CALLS, SET, WHATS } What;

/* The sweeps: what grows, the words before its slope, and its steps. The steps are sides of square pictures,
 * samples, hits, or spheres. */
static const struct {
    const char *name, *label;
    int panel;
    int steps[MOST_STEPS];
} sweeps[WHATS] = {
    [PIXELS] = {"pixels", "", 0, {64, 128, 256, 512, 1024}},
    [SAMPLE_COUNT] = {"samples", "", 1, {1, 4, 16, 64, 256}},
    [DEPTH] = {"depth", "", 2, {1, 2, 4, 8, 16, 32}},
    [CALLS] = {"sphere-calls", "a call each: ", 3, {1, 3, 10, 30, 100}},
    [SET] = {"sphere-set", "one set of all: ", 3, {1, 3, 10, 30, 100, 300, 1000}},
};

static const struct {
    const char *title, *x_label;
    /* Whether the time should be proportional to x. */
    bool proportional;
} panels[] = {
    {"Picture size", "pixels", true},
    {"Samples", "samples a pixel", true},
    {"Depth", "surface hits at most", false},
    {"Shapes", "spheres on a plane", false},
};
enum { PANELS = sizeof panels / sizeof *panels };

/* One point of a sweep: a picture that is rendered again and again. */
typedef struct Step {
    double x;
    uint64_t samples;
    /* The scene of a field. Steps of the user's scene borrow the chart's scene instead. */
    Scene scene;
    bool own_scene, open;
    RenderParams params;
    Renderer renderer;
    double best;
} Step;

typedef struct Scale {
    const ChartParams *params;
    Ledger ledger;
} Scale;

/* Writes and reads a field's scene. Its file is deleted as soon as it is not needed any more. */
static bool write_field(const Scale *scale, Step *step, What what, int count, Error *error) {
    Text text = {0};
    char *path = chart_path(scale->params, "field.glsl");
    (what == SET ? field_of_set : field_of_calls)(count, &text);
    bool ok = file_replace(path, text.data, text.size, error) &&
              scene_read(&step->scene, path, scale->params->picture.scene->file->sources->folder, error);
    step->own_scene = ok;
    text_free(&text);
    free(path);
    return ok;
}

static bool open_step(const Scale *scale, Step *step, What what, int value, Error *error) {
    const ChartParams *params = scale->params;
    *step = (Step){.x = value, .samples = SAMPLES, .params = params->picture, .best = INFINITY};
    if (what == PIXELS) {
        step->x = (double)value * value;
        step->params.width = step->params.height = value;
    }
    if (what == SAMPLE_COUNT) step->samples = (uint64_t)value;
    if (what == DEPTH) step->params.max_hits = value;
    if (what == CALLS || what == SET) {
        if (!write_field(scale, step, what, value, error)) return false;
        step->params.scene = &step->scene;
        step->params.max_hits = 0;
        step->params.sun_disk = NULL;
    }
    /* With this, auto takes the same methods at every size. */
    step->params.samples = 0;
    step->open = renderer_create(&step->renderer, params->context, &step->params, error) &&
                 renderer_pass(&step->renderer, 1, NULL, error);
    return step->open;
}

static void close_step(Step *step) {
    if (step->open) renderer_destroy(&step->renderer);
    if (step->own_scene) scene_destroy(&step->scene);
    *step = (Step){0};
}

static bool time_once(Step *step, const Monitor *monitor, Error *error) {
    Film *film = &step->renderer.film;
    film_reset(film);
    step->renderer.gl->Finish();
    double start = clock_seconds();
    while (film->samples < step->samples && !monitor_stopped(monitor)) {
        if (!renderer_pass(&step->renderer, step->samples - film->samples, monitor->stop, error))
            return false;
    }
    if (!monitor_stopped(monitor)) step->best = fmin(step->best, clock_seconds() - start);
    return true;
}

/* Times a step. Short steps are timed several times, so that the times of small pictures are as good as those
 * of large ones. */
static bool time_step(Step *step, const Monitor *monitor, Error *error) {
    double start = clock_seconds();
    do {
        if (!time_once(step, monitor, error)) return false;
    } while (!monitor_stopped(monitor) && clock_seconds() - start < turn_seconds);
    return true;
}

/* Times all steps of a sweep in alternation, at least twice, and keeps the quickest time of each. */
static bool time_sweep(Step *steps, int count, double seconds, const Monitor *monitor, const char *words,
                       Error *error) {
    double start = clock_seconds(), spent = 0;
    for (int round = 0; round < 2 || spent < seconds; round++) {
        for (int i = 0; i < count; i++) {
            monitor_report(monitor, fmin(spent / seconds, 1), words);
            if (monitor_stopped(monitor)) return true;
            if (!time_step(&steps[i], monitor, error)) return false;
            spent = clock_seconds() - start;
        }
    }
    return true;
}

static int count_steps(What what) {
    int count = 0;
    while (count < MOST_STEPS && sweeps[what].steps[count]) count++;
    return count;
}

static int points_of(const Scale *scale, What what, double *x, double *y) {
    int count = 0;
    for (int i = 0; i < scale->ledger.count && count < MOST_STEPS; i++) {
        const LedgerRow *row = &scale->ledger.rows[i];
        if (strcmp(row->words[0], sweeps[what].name) != 0) continue;
        x[count] = row->numbers[0];
        y[count++] = row->numbers[1];
    }
    return count;
}

static bool keep_steps(Scale *scale, What what, const Step *steps, int count, Error *error) {
    LedgerRow row = {0};
    snprintf(row.words[0], sizeof row.words[0], "%s", sweeps[what].name);
    if (!ledger_drop(&scale->ledger, &row, error)) return false;
    for (int i = 0; i < count; i++) {
        row.numbers[0] = steps[i].x;
        row.numbers[1] = steps[i].best;
        if (!ledger_add(&scale->ledger, &row, error)) return false;
    }
    return true;
}

static bool measure(Scale *scale, What what, Error *error) {
    double x[MOST_STEPS], y[MOST_STEPS];
    int count = count_steps(what);
    if (points_of(scale, what, x, y) == count) return true;
    Step *steps = memory_get((size_t)count, sizeof *steps);
    Monitor monitor = monitor_part(&scale->params->monitor, (double)what / WHATS, (double)(what + 1) / WHATS);
    bool ok = true;
    for (int i = 0; ok && i < count && !monitor_stopped(&monitor); i++)
        ok = open_step(scale, &steps[i], what, sweeps[what].steps[i], error);
    ok = ok && time_sweep(steps, count, scale->params->seconds / WHATS, &monitor, sweeps[what].name, error) &&
         (monitor_stopped(&monitor) || keep_steps(scale, what, steps, count, error));
    for (int i = 0; i < count; i++) close_step(&steps[i]);
    free(steps);
    return ok;
}

/* Returns the y for this x, or 0 if it was not measured. */
static double value_at(const double *x, const double *y, int count, double wanted) {
    for (int i = 0; i < count; i++) {
        if (x[i] == wanted) return y[i];
    }
    return 0;
}

static void draw_sweep(const Scale *scale, Plot *plot, What what) {
    PlotPanel *panel = &plot->panels[sweeps[what].panel];
    double x[MOST_STEPS], y[MOST_STEPS];
    Text words = {0};
    int count = points_of(scale, what, x, y);
    if (count < 2) return;
    double slope = slope_fit(x, y, count), first = value_at(x, y, count, 10);
    if (panels[sweeps[what].panel].proportional) {
        text_print(&words, "slope %.3f, within %.1f %% of proportional", slope,
                   100 * slope_departure(x, y, count));
    } else {
        text_print(&words, "%sslope %.2f", sweeps[what].label, slope);
    }
    if (what == SET) plot_add_note(panel, "1000 of a set cost %.2f times 10", y[count - 1] / first);
    PlotSeries *series = plot_add_series(panel, what == SET, what == SET ? PLOT_SQUARE : PLOT_DOT, PLOT_SOLID,
                                         "%s", text_string(&words));
    for (int i = 0; i < count; i++) plot_add_point(series, x[i], y[i]);
    text_print(scale->params->said, "%s: %s, %g costs %.2f times %g\n", sweeps[what].name,
               text_string(&words), x[count - 1], y[count - 1] / y[0], x[0]);
    text_free(&words);
}

static bool draw(const Scale *scale, Error *error) {
    const ChartParams *params = scale->params;
    Plot *plot = memory_get(1, sizeof *plot);
    Text words = {0};
    chart_describe(params, &words);
    snprintf(plot->title, sizeof plot->title, "Cost against scale: %s", text_string(&words));
    snprintf(plot->subtitle, sizeof plot->subtitle,
             "%d samples a pixel, the quickest of some runs in turns; %s", SAMPLES,
             params->context->renderer);
    plot->panel_count = PANELS;
    for (int i = 0; i < PANELS; i++) {
        PlotPanel *panel = &plot->panels[i];
        snprintf(panel->title, sizeof panel->title, "%s", panels[i].title);
        snprintf(panel->x_label, sizeof panel->x_label, "%s", panels[i].x_label);
        snprintf(panel->y_label, sizeof panel->y_label, "seconds");
    }
    for (int what = 0; what < WHATS; what++) draw_sweep(scale, plot, (What)what);
    char *path = chart_path(params, "scale");
    bool ok = plot_write(plot, path, error);
    free(path);
    text_free(&words);
    free(plot);
    return ok;
}

static bool open_ledger(Scale *scale, Error *error) {
    const ChartParams *params = scale->params;
    Text identity = {0};
    uint64_t hash = 0;
    text_print(&identity, "%s", params->identity);
    identity_of_picture(&params->picture, &identity);
    bool ok = identity_add_shader(&params->picture, &hash, error);
    text_print(&identity, "# shader %016" PRIx64 "\n", hash);
    char *path = chart_path(params, "scale.csv");
    ok = ok &&
         ledger_open(&scale->ledger, path, text_string(&identity), 1, "what,x,seconds", params->said, error);
    free(path);
    text_free(&identity);
    return ok;
}

bool chart_scale(const ChartParams *params, Error *error) {
    Scale scale = {.params = params};
    bool ok = open_ledger(&scale, error);
    for (int what = 0; ok && what < WHATS && !monitor_stopped(&params->monitor); what++)
        ok = measure(&scale, (What)what, error);
    if (ok && !monitor_stopped(&params->monitor)) ok = draw(&scale, error);
    char *field = chart_path(params, "field.glsl");
    unlink(field);
    free(field);
    ledger_close(&scale.ledger);
    return ok;
}
