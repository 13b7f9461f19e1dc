#include "chart/chart.h"
#include "chart/identity.h"

#include "base/known.h"
#include "base/version.h"
#include "choice/auto.h"
#include "cmd/cmd.h"
#include "cmd/gauge.h"
#include "cmd/interrupt.h"
#include "cmd/setup.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { DEFAULT_SIDE = 256 };
static const double default_seconds = 150;

/* The share of the time that each chart gets. */
static const struct {
    const char *name;
    bool (*make)(const ChartParams *params, Error *error);
    double share;
} charts[] = {{"paths", chart_paths, 0.6}, {"sky", chart_sky, 0.1}, {"scale", chart_scale, 0.3}};
enum { CHARTS = sizeof charts / sizeof *charts };

typedef struct Job {
    const Options *options;
    char *library;
    Scene scene;
    Context context;
    bool wanted[CHARTS];
    Points points;
    Text identity, said;
    Gauge gauge;
    SkyWatch watch;
} Job;

static bool unknown_chart(const char *name, size_t length, Error *error) {
    Known known = known_to(name, length);
    for (int i = 0; i < CHARTS; i++) known_add(&known, charts[i].name);
    return known_fail(&known, STATUS_USAGE, error, "--charts: unknown '%.*s'", (int)length, name);
}

/* Reads a list such as "paths,sky". */
static bool choose_charts(const char *list, bool wanted[CHARTS], Error *error) {
    if (!list) memset(wanted, true, CHARTS * sizeof *wanted);
    while (list) {
        size_t length = strcspn(list, ",");
        int at = 0;
        while (at < CHARTS && (strlen(charts[at].name) != length || strncmp(charts[at].name, list, length)))
            at++;
        if (at == CHARTS) return unknown_chart(list, length, error);
        wanted[at] = true;
        list = list[length] ? list + length + 1 : NULL;
    }
    return true;
}

static bool make_folder(const char *folder, Error *error) {
    struct stat status;
    if (strcmp(folder, "-") == 0)
        return error_set(error, STATUS_USAGE, "-o -: charts are several files, so -o names a folder");
    if (mkdir(folder, 0777) == 0) return true;
    int failed = errno;
    if (failed == EEXIST && stat(folder, &status) == 0 && S_ISDIR(status.st_mode)) return true;
    return error_set(error, STATUS_OUTPUT, "-o %s: no folder can be made there: %s", folder,
                     strerror(failed));
}

static bool read_points(Job *job, Error *error) {
    const Options *options = job->options;
    if (!options->points) return true;
    if (options->error.measure == NOISE_LEVELS)
        return error_set(error, STATUS_USAGE,
                         "--points: the points are in percent, and --error asks for levels");
    return points_read(&job->points, options->points, error);
}

static bool prepare(Job *job, Error *error) {
    const Options *options = job->options;
    if (options->output_count != 1) return error_set(error, STATUS_USAGE, "where to? (-o DIR, one folder)");
    return choose_charts(options->charts, job->wanted, error) && read_points(job, error) &&
           setup_library(options, &job->library, error) &&
           setup_scene(options, job->library, &job->scene, error) &&
           (!options->width || scene_check_size(options->width, options->height, error)) &&
           make_folder(options->outputs[0], error) && context_open(&job->context, options->backend, error);
}

/* What is measured is kept, so that the next run goes on with it. */
static void report(void *data, double share, const char *what) {
    interrupt_keep();
    gauge_report(data, share, what);
}

static bool make_charts(Job *job, Error *error) {
    const Options *options = job->options;
    double seconds = options->seconds > 0 ? options->seconds : default_seconds, whole = 0, done = 0;
    ErrorTarget usual = {.amount = AUTO_ERROR_PERCENT};
    ErrorTarget target = options->error.amount > 0 ? options->error : usual;
    RenderParams picture = setup_params(options, &job->scene);
    if (!options->width) picture.width = picture.height = DEFAULT_SIDE;
    picture.error_percent = target_percent(target, TONE_AUTHOR);
    picture.watch = &job->watch;
    ChartParams params = {.context = &job->context,
                          .picture = picture,
                          .folder = options->outputs[0],
                          .identity = text_string(&job->identity),
                          .target = target,
                          .points = options->points ? &job->points : NULL,
                          .said = &job->said};
    Monitor all = {interrupt_requested, report, &job->gauge, 0, 1};
    for (int i = 0; i < CHARTS; i++) whole += job->wanted[i] ? charts[i].share : 0;
    for (int i = 0; i < CHARTS && !interrupt_requested(); i++) {
        if (!job->wanted[i]) continue;
        double share = charts[i].share / whole;
        params.monitor = monitor_part(&all, done, done + share);
        params.seconds = share * seconds;
        /* What is measured so far is in the CSV. */
        if (!interrupt_forgive(charts[i].make(&params, error), error)) return false;
        done += share;
    }
    return true;
}

static void say_results(const Job *job) {
    const char *folder = job->options->outputs[0];
    if (!job->options->quiet) fputs(text_string(&job->said), stdout);
    if (interrupt_requested()) {
        fprintf(stderr, "magichour: interrupted: what was measured is in %s, the same command goes on\n",
                folder);
        return;
    }
    bool levels = job->options->error.measure == NOISE_LEVELS;
    for (int i = 0; i < CHARTS && !job->options->quiet; i++) {
        const char *name = levels && charts[i].make == chart_paths ? CHART_PATHS_LEVELS : charts[i].name;
        if (job->wanted[i])
            printf("%s/%s.csv, %s/%s.svg, %s/%s.png\n", folder, name, folder, name, folder, name);
    }
}

Status cmd_chart(const Options *options, Error *error) {
    Job job = {.options = options};
    error->status = STATUS_DONE;
    interrupt_install();
    bool ok = prepare(&job, error);
    if (ok) {
        text_print(&job.identity, "# magichour %s\n", MAGICHOUR_VERSION);
        identity_of_machine(&job.context, &job.identity);
        job.gauge = gauge_start(options);
        job.watch = (SkyWatch){gauge_watch_tables, &job.gauge};
        ok = make_charts(&job, error);
        gauge_end(&job.gauge, interrupt_requested());
        if (ok) say_results(&job);
    }
    context_close(&job.context);
    scene_destroy(&job.scene);
    free(job.library);
    text_free(&job.identity);
    text_free(&job.said);
    return !ok ? error->status : interrupt_requested() ? STATUS_INTERRUPTED : STATUS_DONE;
}
