#include "chart/chart_further.h"

#include "base/clock.h"
#include "base/memory.h"
#include "chart/ledger.h"
#include "chart/plot_write.h"
#include "chart/reference.h"
#include "chart/sky_error.h"
#include "sky/sky_probe.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { TIMED = 2 };

/* The numbers of a row. */
enum { SECONDS, RMS, P99, LARGEST };

typedef struct FurtherJob {
    const ChartParams *params;
    const SkyState *state;
    const float *directions;
    const double *truth;
    int count;
    SkyProbe probe;
    float *radiances;
    Ledger ledger;
    /* The seconds in which the table of another sun is filled and the directions are looked up, of each row.
     */
    double sun_seconds[METHOD_MOST_VARIANTS];
} FurtherJob;

/* Asks for all directions, and measures the seconds of that: most of them fill tables. */
static bool ask(FurtherJob *job, const SkyState *state, double *seconds, Error *error) {
    double start = clock_seconds();
    bool ok = sky_probe_ask(&job->probe, state, job->directions, (size_t)job->count, job->radiances, error);
    *seconds = fmin(*seconds, clock_seconds() - start);
    return ok;
}

/* The quickest of some runs counts, because other programs can only make a run slower. Tables are filled anew
 * for a planet, and for a sun, that differ by less than shows. */
static bool measure(FurtherJob *job, const char *quality, Error *error) {
    double ignored = INFINITY, once = INFINITY, sun = INFINITY;
    LedgerRow row = {0};
    if (!method_choose(&job->probe.further, METHOD_FURTHER, quality, error) ||
        !ask(job, job->state, &ignored, error))
        return false;
    SkyError errors = sky_error(job->radiances, job->truth, job->count);
    for (int i = 1; i <= TIMED && !monitor_stopped(&job->params->monitor); i++) {
        SkyState state = *job->state;
        state.atmosphere.planet_radius_m *= 1 + 1e-8 * i;
        if (!ask(job, &state, &once, error)) return false;
        state.sun.elevation_deg += 1e-6;
        if (!ask(job, &state, &sun, error)) return false;
    }
    snprintf(row.words[0], sizeof row.words[0], "%s", quality);
    row.numbers[SECONDS] = fmax(once - sun, 0);
    row.numbers[RMS] = errors.rms;
    row.numbers[P99] = errors.p99;
    row.numbers[LARGEST] = errors.largest;
    job->sun_seconds[job->ledger.count] = sun;
    return monitor_stopped(&job->params->monitor) || ledger_add(&job->ledger, &row, error);
}

static void draw_points(const FurtherJob *job, PlotPanel *panel) {
    PlotSeries *series =
        plot_add_series(panel, 1, PLOT_DOT, PLOT_SOLID, "harmonics:n, harmonics up to degree n");
    for (int i = 0; i < job->ledger.count; i++) {
        const LedgerRow *row = &job->ledger.rows[i];
        int before = series->count, degree = 0;
        plot_add_point(series, row->numbers[SECONDS], row->numbers[RMS]);
        if (series->count == before || sscanf(row->words[0], "harmonics:%d", &degree) != 1) continue;
        series->points[before].high = fmax(row->numbers[P99], row->numbers[RMS]);
        snprintf(series->points[before].label, sizeof series->points[before].label, "%d", degree);
        plot_add_note(panel, "harmonics:%d: another sun takes %.0f ms", degree, 1e3 * job->sun_seconds[i]);
    }
    plot_add_note(panel, "points: RMS; whiskers up to the 99th percentile");
}

static bool draw(const FurtherJob *job, Error *error) {
    const ChartParams *params = job->params;
    Plot *plot = memory_get(1, sizeof *plot);
    PlotPanel *panel = &plot->panels[plot->panel_count++];
    snprintf(plot->title, sizeof plot->title, "All orders of scattering: error against cost, sun at %g",
             job->state->sun.elevation_deg);
    snprintf(plot->subtitle, sizeof plot->subtitle,
             "%d directions from %g m high, all light by " REFERENCE_SKY " and --further; %s", job->count,
             job->state->atmosphere.observer_height_m, params->context->renderer);
    snprintf(panel->x_label, sizeof panel->x_label, "seconds to fill the tables of an air, once");
    snprintf(panel->y_label, sizeof panel->y_label, "error of radiance, %%");
    draw_points(job, panel);
    char *path = chart_path(params, "further");
    bool ok = plot_write(plot, path, error);
    if (ok) text_print(params->said, "%s.csv, %s.svg, %s.png\n", path, path, path);
    free(path);
    free(plot);
    return ok;
}

/* Rows of before are not kept. */
static bool open_ledger(FurtherJob *job, Error *error) {
    Text identity = {0};
    char *path = chart_path(job->params, "further.csv");
    text_print(&identity, "%s# sun %.9g\n", job->params->identity, job->state->sun.elevation_deg);
    unlink(path);
    bool ok =
        ledger_open(&job->ledger, path, text_string(&identity), 1,
                    "further,once_seconds,rms_percent,p99_percent,largest_percent", job->params->said, error);
    text_free(&identity);
    free(path);
    return ok;
}

bool chart_further(const ChartParams *params, const SkyState *state, const float *directions,
                   const double *truth, int count, Error *error) {
    FurtherJob job = {
        .params = params, .state = state, .directions = directions, .truth = truth, .count = count};
    MethodChoice sky, further;
    if (!method_choose(&sky, METHOD_SKY, REFERENCE_SKY, error) ||
        !method_choose(&further, METHOD_FURTHER, NULL, error) ||
        !sky_probe_create(&job.probe, params->context, params->picture.scene->file->sources, &sky,
                          &state->atmosphere, error))
        return false;
    job.probe.watch = params->picture.watch;
    job.radiances = memory_get(4 * (size_t)count, sizeof *job.radiances);
    bool ok = open_ledger(&job, error);
    for (int i = 0; ok && i < METHOD_MOST_VARIANTS && !monitor_stopped(&params->monitor); i++) {
        monitor_report(&params->monitor, 1, "filling tables of the further orders");
        ok = measure(&job, further.method->variants[i], error);
    }
    ok = ok && (monitor_stopped(&params->monitor) || draw(&job, error));
    ledger_close(&job.ledger);
    sky_probe_destroy(&job.probe);
    free(job.radiances);
    return ok;
}
