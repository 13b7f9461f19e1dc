#include "base/memory.h"
#include "chart/chart.h"

#include "base/clock.h"
#include "base/vec3.h"
#include "chart/chart_further.h"
#include "chart/identity.h"
#include "chart/ledger.h"
#include "chart/plot_write.h"
#include "chart/sky_error.h"
#include "sky/sky_probe.h"
#include "sky/sky_truth.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DIRECTIONS = 512, TIMED = 65536 };

static const double turn_seconds = 0.03;

/* The cost of this method is that of a pass without a sky. */
static const char nothing[] = "uniform:1";

/* The numbers of a row. */
enum { NANOSECONDS, RMS, P99, LARGEST };

/* The curves: the methods of each, and the words beside their points. */
static const struct {
    const char *label, *methods[6], *words[6];
    PlotMarker marker;
    PlotLine line;
} families[] = {
    {"paper:NxM, the paper's sums",
     {"paper:8x2", "paper:16x4", "paper:32x8", "paper:64x16", "paper:128x32"},
     {"8x2", "16x4", "32x8", "64x16", "128x32"},
     PLOT_DIAMOND,
     PLOT_SOLID},
    {"gauss:n, n nodes a segment",
     {"gauss:4", "gauss:6", "gauss:8", "gauss:10", "gauss:12"},
     {"4", "6", "8", "10", "12"},
     PLOT_DOT,
     PLOT_SOLID},
    {"table:METHOD, looked up",
     {"table:gauss:4", "table:gauss:6", "table:gauss:8", "table:gauss:8@128x384", "table:paper:16x4"},
     {"gauss:4", "gauss:6", "gauss:8", "8@128x384", "paper:16x4"},
     PLOT_SQUARE,
     PLOT_NO_LINE},
};
enum { FAMILIES = sizeof families / sizeof *families, MOST_METHODS = 6 };

typedef struct SkyJob {
    const ChartParams *params;
    SkyState state;
    Ledger ledger;
    float directions[4 * TIMED];
    double truth[3 * DIRECTIONS];
} SkyJob;

/* Chooses directions that are even over the sky above the visible horizon, by Roberts' recurrence in two
 * dimensions. */
static void choose_directions(SkyJob *job) {
    double horizon = sky_horizon_sine(&job->state.atmosphere);
    for (int i = 0; i < TIMED; i++) {
        double up = horizon + (1 - horizon) * fmod(0.5 + 0.75487766624669276 * i, 1);
        double around = 360 * degree * fmod(0.5 + 0.56984029099805327 * i, 1), level = sqrt(1 - up * up);
        job->directions[4 * i] = (float)(level * sin(around));
        job->directions[4 * i + 1] = (float)up;
        job->directions[4 * i + 2] = (float)(level * cos(around));
    }
}

/* Solving for the further orders is most of it, where there are any. */
static bool watch_solution(void *state, double share) {
    const Monitor *monitor = &((const SkyJob *)state)->params->monitor;
    monitor_report(monitor, 0.18 * share, "all orders of scattering in double precision");
    return !monitor_stopped(monitor);
}

static void find_truth(SkyJob *job) {
    const SkyState *s = &job->state;
    const SkyWatch watch = {watch_solution, job};
    double elevation = s->sun.elevation_deg * degree, azimuth = s->sun.azimuth_deg * degree;
    double sun[3] = {cos(elevation) * sin(azimuth), sin(elevation), cos(elevation) * cos(azimuth)};
    SkyTruth *truth = sky_truth_create(&s->atmosphere, &watch);
    for (int i = 0; truth && i < DIRECTIONS && !monitor_stopped(&job->params->monitor); i++) {
        const float *direction = job->directions + 4 * i;
        double view[3] = {(double)direction[0], (double)direction[1], (double)direction[2]};
        monitor_report(&job->params->monitor, 0.18 + 0.02 * i / DIRECTIONS, "the sky by adaptive quadrature");
        sky_truth_ask(truth, s->atmosphere.observer_height_m, view, sun, job->truth + 3 * i);
    }
    sky_truth_destroy(truth);
}

static void judge(const SkyJob *job, const float *radiances, LedgerRow *row) {
    SkyError errors = sky_error(radiances, job->truth, DIRECTIONS);
    row->numbers[RMS] = errors.rms;
    row->numbers[P99] = errors.p99;
    row->numbers[LARGEST] = errors.largest;
}

static const LedgerRow *find(const SkyJob *job, const char *method) {
    LedgerRow like = {0};
    snprintf(like.words[0], sizeof like.words[0], "%s", method);
    for (int i = 0; i < job->ledger.count; i++) {
        if (ledger_same(&job->ledger, &job->ledger.rows[i], &like)) return &job->ledger.rows[i];
    }
    return NULL;
}

/* A method that is not in the CSV yet. */
typedef struct Open {
    const char *method;
    SkyProbe probe;
    /* Seconds: the least for one lookup, and all timing together. */
    double best, spent;
} Open;

static bool open_method(SkyJob *job, Open *open, const char *method, Error *error) {
    MethodChoice choice;
    *open = (Open){.method = method, .best = INFINITY};
    bool ok = method_choose(&choice, METHOD_SKY, method, error) &&
              sky_probe_create(&open->probe, job->params->context, job->params->picture.scene->file->sources,
                               &choice, &job->state.atmosphere, error);
    open->probe.watch = job->params->picture.watch;
    return ok;
}

/* Times the methods in alternation, each at least once. A method that has used its share of the time is
 * skipped. */
static bool time_methods(SkyJob *job, Open *open, int count, Error *error) {
    double share = job->params->seconds / count;
    bool timed = true;
    for (int round = 0; timed; round++) {
        timed = false;
        for (int i = 0; i < count; i++) {
            double start = clock_seconds(), seconds;
            if (monitor_stopped(&job->params->monitor)) return true;
            if (round && open[i].spent > share) continue;
            monitor_report(&job->params->monitor, 0.2 + 0.8 * fmin(open[i].spent / share, 1),
                           "timing skies in turns");
            if (!sky_probe_time(&open[i].probe, &job->state, job->directions, TIMED, turn_seconds, &seconds,
                                error))
                return false;
            open[i].best = fmin(open[i].best, seconds);
            open[i].spent += clock_seconds() - start;
            timed = true;
        }
    }
    return true;
}

static bool keep(SkyJob *job, Open *open, Error *error) {
    LedgerRow row = {.numbers = {[NANOSECONDS] = 1e9 * open->best}};
    float radiances[4 * DIRECTIONS];
    snprintf(row.words[0], sizeof row.words[0], "%s", open->method);
    if (!sky_probe_ask(&open->probe, &job->state, job->directions, DIRECTIONS, radiances, error))
        return false;
    if (strcmp(open->method, nothing) != 0) judge(job, radiances, &row);
    return ledger_add(&job->ledger, &row, error);
}

static bool measure(SkyJob *job, Error *error) {
    Open *open = memory_get(FAMILIES * MOST_METHODS + 1, sizeof *open);
    int count = 0;
    bool ok = find(job, nothing) || open_method(job, &open[count++], nothing, error);
    for (int i = 0; ok && i < FAMILIES * MOST_METHODS; i++) {
        const char *method = families[i / MOST_METHODS].methods[i % MOST_METHODS];
        if (method && !find(job, method)) ok = open_method(job, &open[count++], method, error);
    }
    ok = ok && time_methods(job, open, count, error);
    for (int i = 0; i < count; i++) {
        if (ok && !monitor_stopped(&job->params->monitor)) ok = keep(job, &open[i], error);
        sky_probe_destroy(&open[i].probe);
    }
    free(open);
    return ok;
}

static void draw_family(const SkyJob *job, int f, PlotPanel *panel) {
    PlotSeries *series =
        plot_add_series(panel, f, families[f].marker, families[f].line, "%s", families[f].label);
    double others = find(job, nothing)->numbers[NANOSECONDS];
    for (int i = 0; i < MOST_METHODS && families[f].methods[i]; i++) {
        const LedgerRow *row = find(job, families[f].methods[i]);
        int before = series->count;
        plot_add_point(series, fmax(row->numbers[NANOSECONDS] - others, 0.1), row->numbers[RMS]);
        if (series->count == before) continue;
        PlotPoint *point = &series->points[before];
        point->high = fmax(row->numbers[P99], row->numbers[RMS]);
        snprintf(point->label, sizeof point->label, "%s", families[f].words[i]);
    }
}

static bool draw(const SkyJob *job, Error *error) {
    const ChartParams *params = job->params;
    Plot *plot = memory_get(1, sizeof *plot);
    PlotPanel *panel = &plot->panels[plot->panel_count++];
    const Atmosphere *a = &job->state.atmosphere;
    snprintf(plot->title, sizeof plot->title, "The sky: error against cost of a lookup, sun at %g",
             job->state.sun.elevation_deg);
    snprintf(plot->subtitle, sizeof plot->subtitle,
             "%d directions from %g m high, against adaptive quadrature; %s", DIRECTIONS,
             a->observer_height_m, params->context->renderer);
    snprintf(panel->x_label, sizeof panel->x_label, "nanoseconds a lookup");
    snprintf(panel->y_label, sizeof panel->y_label, "error of radiance, %%");
    for (int f = 0; f < FAMILIES; f++) draw_family(job, f, panel);
    plot_add_note(panel, "points: RMS; whiskers up to the 99th percentile");
    plot_add_note(panel, "%.2g ns of any pass without a sky are taken off",
                  find(job, nothing)->numbers[NANOSECONDS]);
    char *path = chart_path(params, "sky");
    bool ok = plot_write(plot, path, error);
    free(path);
    free(plot);
    return ok;
}

static bool open_ledger(SkyJob *job, Error *error) {
    const ChartParams *params = job->params;
    const Atmosphere *a = &job->state.atmosphere;
    Text identity = {0};
    uint64_t hash = 0;
    bool ok = true;
    for (int f = 0; ok && f < FAMILIES; f++) {
        RenderParams picture = params->picture;
        picture.sky = families[f].methods[0];
        ok = identity_add_shader(&picture, &hash, error);
    }
    text_print(&identity, "%s# sun %.9g,%.9g\n# atmosphere", params->identity, job->state.sun.elevation_deg,
               job->state.sun.azimuth_deg);
    for (int i = 0; atmosphere_field(i); i++) {
        const double *value = atmosphere_value(a, atmosphere_field(i));
        for (int k = 0; k < atmosphere_field(i)->count; k++) text_print(&identity, " %.9g", value[k]);
    }
    text_print(&identity, "\n# shaders %016" PRIx64 "\n", hash);
    char *path = chart_path(params, "sky.csv");
    ok = ok && ledger_open(&job->ledger, path, text_string(&identity), 1,
                           "sky,ns_per_lookup,rms_percent,p99_percent,largest_percent", params->said, error);
    free(path);
    text_free(&identity);
    return ok;
}

bool chart_sky(const ChartParams *params, Error *error) {
    const Scene *scene = params->picture.scene;
    SkyJob *job = memory_get(1, sizeof *job);
    job->params = params;
    job->state = (SkyState){scene->values.atmosphere, scene->values.sun};
    choose_directions(job);
    bool ok = open_ledger(job, error);
    if (ok) find_truth(job);
    ok = ok && (monitor_stopped(&params->monitor) || measure(job, error));
    if (ok && !monitor_stopped(&params->monitor)) ok = draw(job, error);
    if (ok && job->state.atmosphere.orders > 1 && !monitor_stopped(&params->monitor))
        ok = chart_further(params, &job->state, job->directions, job->truth, DIRECTIONS, error);
    ledger_close(&job->ledger);
    free(job);
    return ok;
}
