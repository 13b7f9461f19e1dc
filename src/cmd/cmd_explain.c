#include "chart/worth.h"
#include "choice/auto.h"
#include "cmd/cmd.h"
#include "cmd/gauge.h"
#include "cmd/interrupt.h"
#include "cmd/library_files.h"
#include "cmd/setup.h"
#include "scene/mist_words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEFAULT_SIDE = 128, SAMPLES = 64 };
/* A way to less noise is called needed from this gain in time on; a smaller one is within the error of
 * timing. */
static const double least_gain = 1.1;
/* A shorter time for tables is not told: it is that of a frame or two. */
static const double least_seconds = 0.05;

typedef struct Job {
    const Options *options;
    char *library;
    Scene scene;
    RenderParams params;
    Context context;
    WorthBase base;
    /* The target error. */
    double percent;
    Text table;
    Gauge gauge;
    SkyWatch watch;
} Job;

static bool prepare(Job *job, Error *error) {
    const Options *options = job->options;
    if (!setup_library(options, &job->library, error) ||
        !setup_scene(options, job->library, &job->scene, error))
        return false;
    if (options->width && !scene_check_size(options->width, options->height, error)) return false;
    job->percent = options->error.amount > 0 ? options->error.amount : AUTO_ERROR_PERCENT;
    job->params = setup_params(options, &job->scene);
    if (!options->width) job->params.width = job->params.height = DEFAULT_SIDE;
    job->params.error_percent = job->percent;
    job->params.watch = &job->watch;
    gauge_report(&job->gauge, 0, "the picture itself");
    return context_open(&job->context, options->backend, error) &&
           worth_begin(&job->base, &job->context, &job->params, SAMPLES, interrupt_requested, error);
}

static const char *verdict_of(const Job *job, const Term *term, const Worth *worth) {
    if (worth->state != TERM_ON) return "off here";
    if (term->same_picture) return worth->gain > least_gain ? "needed" : "not needed";
    /* A term counts as needed if its change may be more than the target error. */
    return fmax(worth->change_percent, worth->change_known) > job->percent ? "needed" : "not needed";
}

/* Prints such as "0.31", or "< 0.02" if no more is known. */
static void print_change(const Term *term, const Worth *worth, char *out, size_t size) {
    if (worth->state == TERM_NONE) {
        snprintf(out, size, "-");
    } else if (term->same_picture) {
        snprintf(out, size, "%.2f x", worth->gain);
    } else if (worth->change_percent < worth->change_known) {
        snprintf(out, size, "< %.2g", fmax(worth->change_known, 0.001));
    } else {
        snprintf(out, size, "%.3g", worth->change_percent);
    }
}

static void print_row(Job *job, const Term *term, const Worth *worth) {
    char change[32], cost[32] = "-", once[32] = "-";
    print_change(term, worth, change, sizeof change);
    if (worth->state != TERM_NONE) snprintf(cost, sizeof cost, "%+.0f", worth->cost_percent);
    if (fabs(worth->once_seconds) > least_seconds) snprintf(once, sizeof once, "%+.2f", worth->once_seconds);
    text_print(&job->table, "  %-32s %9s %8s %8s   %s\n", term->name, change, cost, once,
               verdict_of(job, term, worth));
}

static void print_heading(Job *job, bool same_picture) {
    text_print(&job->table,
               same_picture ? "\n  %-32s %9s %8s %8s   at the same noise\n" : "  %-32s %9s %8s %8s\n",
               same_picture ? "ways to the same picture" : "terms of the model",
               same_picture ? "saves" : "change, %", "cost, %", "once, s");
}

static bool explain(Job *job, Error *error) {
    int count;
    Term *terms = term_list(&job->params, &count);
    bool ok = true;
    int done = 0;
    for (int part = 0; part < 2; part++) {
        print_heading(job, part == 1);
        for (int i = 0; ok && i < count && !interrupt_requested(); i++) {
            Worth worth;
            if (terms[i].same_picture != (part == 1)) continue;
            gauge_report(&job->gauge, (double)++done / (count + 1), terms[i].name);
            ok = worth_of(&job->base, &terms[i], interrupt_requested, &worth, error);
            if (!ok || interrupt_requested()) continue;
            print_row(job, &terms[i], &worth);
            interrupt_keep();
        }
    }
    free(terms);
    return ok;
}

static void print_compiled(Job *job) {
    text_print(&job->table, "\ncompiled: %s, and of the library\n", job->scene.file->path);
    library_files_print(job->library, text_string(&job->base.renderer.source_files), &job->table);
}

/* What the scene's rows `mist` and `air` turn on and off. */
static void print_mist(const Scene *scene) {
    Text words = {0};
    mist_words(scene, &words);
    if (words.size) printf("\n%s", text_string(&words));
    text_free(&words);
}

static void print_results(const Job *job) {
    const Scene *scene = &job->scene;
    const Renderer *renderer = &job->base.renderer;
    bool further = renderer->plan.sky.method->integrates && scene->values.atmosphere.orders > 1;
    printf(
        "%s, %dx%d, sun at %g, at an error of %g %%: sky %s, sun's disk %s, light %s, sequence %s%s%s\n\n%s",
        scene->file->title[0] ? scene->file->title : scene->file->path, renderer->film.width,
        renderer->film.height, scene->values.sun.elevation_deg, job->percent, renderer->plan.sky.text,
        renderer->plan.sun.text, renderer->plan.light.text, renderer->plan.sequence.text,
        further ? ", further orders " : "", further ? renderer->plan.further.text : "",
        text_string(&job->table));
    print_mist(scene);
}

Status cmd_explain(const Options *options, Error *error) {
    Job job = {.options = options, .gauge = gauge_start(options)};
    job.watch = (SkyWatch){gauge_watch_tables, &job.gauge};
    error->status = STATUS_DONE;
    interrupt_install();
    bool begun = prepare(&job, error), ok = begun && explain(&job, error);
    gauge_end(&job.gauge, interrupt_requested());
    /* The rows that are there are worth printing. */
    ok = interrupt_forgive(ok, error);
    if (begun && ok) {
        if (options->files) print_compiled(&job);
        print_results(&job);
    }
    if (ok && interrupt_requested()) fputs("magichour: interrupted: the rows so far are printed\n", stderr);
    if (begun) worth_end(&job.base);
    context_close(&job.context);
    scene_destroy(&job.scene);
    free(job.library);
    text_free(&job.table);
    return !ok ? error->status : interrupt_requested() ? STATUS_INTERRUPTED : STATUS_DONE;
}
