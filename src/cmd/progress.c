#include "cmd/progress.h"

#include "base/clock.h"
#include "base/json.h"
#include "cmd/interrupt.h"
#include "cmd/terminal.h"
#include "error/noise_figures.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The seconds between two reports in lines. */
static const double line_seconds = 5;

Progress progress_start(const Options *options) {
    static const struct {
        const char *name;
        ProgressKind kind;
    } kinds[] = {{"tty", PROGRESS_TTY}, {"lines", PROGRESS_LINES}, {"json", PROGRESS_JSON}};
    Progress progress = {.kind = PROGRESS_NONE, .last = -INFINITY};
    for (size_t i = 0; options->progress && i < sizeof kinds / sizeof *kinds; i++) {
        if (strcmp(options->progress, kinds[i].name) == 0) progress.kind = kinds[i].kind;
    }
    if (!options->progress && !options->quiet)
        progress.kind = isatty(STDERR_FILENO) ? PROGRESS_TTY : PROGRESS_LINES;
    if (progress.kind == PROGRESS_LINES) progress.last = clock_seconds();
    return progress;
}

bool progress_due(Progress *progress) {
    double now = clock_seconds();
    if (progress->kind == PROGRESS_NONE) return false;
    if (now - progress->last < (progress->kind == PROGRESS_LINES ? line_seconds : 0.1)) return false;
    progress->last = now;
    return true;
}

/* On a terminal the line is cut to the width. Otherwise it would wrap and scroll at each report. */
void progress_words(Progress *progress, const char *words) {
    if (progress->kind == PROGRESS_LINES) fprintf(stderr, "magichour: %s\n", words);
    if (progress->kind != PROGRESS_TTY) return;
    fprintf(stderr, "\r%.*s\033[K", terminal_columns(STDERR_FILENO) - 1, words);
    progress->line = true;
    interrupt_line(true);
}

void progress_begin(Progress *progress, const char *words) {
    if (progress->kind == PROGRESS_TTY) progress_words(progress, words);
}

void progress_clear(Progress *progress) {
    if (progress->line) fputs("\r\033[K", stderr);
    progress->line = false;
    interrupt_line(false);
}

static double seconds_left(const ProgressFigures *figures) {
    double left = INFINITY;
    if (figures->target_samples && figures->samples > 0)
        left = figures->seconds * ((double)figures->target_samples / figures->samples - 1);
    /* The error falls with the square root of the time, or a little faster. */
    double error = figures->error[figures->target.measure];
    if (figures->target.amount > 0 && error < INFINITY)
        left = figures->seconds * (pow(error / figures->target.amount, 2) - 1);
    if (figures->target_seconds > 0) left = fmin(left, figures->target_seconds - figures->seconds);
    return fmax(left, 0);
}

static void report_words(Progress *progress, const ProgressFigures *figures) {
    char words[200], target[32] = "", reached[64] = "", left[32] = "";
    if (figures->target_samples) snprintf(target, sizeof target, " of %" PRIu64, figures->target_samples);
    double error = figures->error[figures->target.measure];
    if (error < INFINITY)
        snprintf(reached, sizeof reached, "error about %.2g %s, ", error,
                 figures->target.measure == NOISE_LEVELS ? "levels" : "%");
    if (seconds_left(figures) < INFINITY)
        snprintf(left, sizeof left, ", %.0f s left", ceil(seconds_left(figures)));
    snprintf(words, sizeof words, "%s%.0f%s samples, %.1f Mpaths/s%s", reached, figures->samples, target,
             1e-6 * (double)figures->paths / fmax(figures->seconds, 1e-9), left);
    progress_words(progress, words);
}

static void report_errors(Json *json, const ProgressFigures *figures) {
    static const char *const errors[] = {"error_percent", "error_levels"};
    static const char *const noises[] = {"noise_percent", "noise_levels"};
    for (int i = 0; i < NOISE_MEASURES; i++) {
        if (!(figures->error[i] < INFINITY)) continue;
        json_number(json, errors[i], figures->error[i]);
        json_number(json, noises[i], figures->noise[i]);
    }
    if (!figures->done || !figures->promise) return;
    json_flag(json, "promised", figures->promise->given);
    if (figures->promise->given) return;
    json_text(json, "unpromised_reason", figures->promise->reason);
    json_number(json, "unpromised_pixels_percent", 100 * figures->promise->pixels);
}

static void report_json(const ProgressFigures *figures) {
    Json json = json_begin();
    json_flag(&json, "done", figures->done);
    json_number(&json, "samples", figures->samples);
    json_count(&json, "paths", figures->paths);
    if (figures->light_paths > 0) json_count(&json, "light_paths", (uint64_t)figures->light_paths);
    json_seconds(&json, "seconds", figures->seconds);
    json_seconds(&json, "startup_seconds", figures->startup_seconds);
    json_number(&json, "paths_per_s", (double)figures->paths / fmax(figures->seconds, 1e-9));
    report_errors(&json, figures);
    if (figures->done) {
        json_count(&json, "rejected", figures->rejected);
        if (figures->light_rejected) json_count(&json, "light_rejected", figures->light_rejected);
        json_flag(&json, "interrupted", figures->interrupted);
        if (figures->sun_by_chance) json_flag(&json, "sun_by_chance", true);
        if (figures->chance.paths > 0) {
            json_number(&json, "chance_paths_percent", 100 * figures->chance.paths);
            json_number(&json, "chance_pixels_percent", 100 * figures->chance.pixels);
            json_number(&json, "chance_light_percent", 100 * figures->chance.light);
        }
        if (figures->search_rays > 0) {
            json_number(&json, "search_rays", figures->search_rays);
            json_number(&json, "search_steps", figures->search_steps);
            json_number(&json, "search_broken", figures->search_broken);
            json_number(&json, "search_cut", figures->search_cut);
        }
    }
    json_end(&json, stderr);
}

void progress_prepare(Progress *progress, double share, double seconds) {
    char words[64];
    if (share == 1 || seconds < 0.5 || !progress_due(progress)) return;
    if (progress->kind == PROGRESS_JSON) {
        Json json = json_begin();
        json_flag(&json, "done", false);
        json_number(&json, "prepared", share);
        json_seconds(&json, "seconds", seconds);
        json_end(&json, stderr);
    } else {
        snprintf(words, sizeof words, "computing the sky, %.0f %%", floor(100 * share));
        progress_words(progress, words);
    }
}

void progress_report(Progress *progress, const ProgressFigures *figures) {
    if (figures->done) progress_clear(progress);
    if (!figures->done && !progress_due(progress)) return;
    if (progress->kind == PROGRESS_JSON)
        report_json(figures);
    else if (!figures->done)
        report_words(progress, figures);
}
