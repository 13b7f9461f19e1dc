#include "cmd/progress.h"

#include "base/json.h"
#include "cmd/terminal.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

Progress progress_start(const Options *options) {
    Progress progress = {.kind = PROGRESS_NONE, .last = -1};
    if (options->progress) {
        if (strcmp(options->progress, "tty") == 0) progress.kind = PROGRESS_TTY;
        if (strcmp(options->progress, "json") == 0) progress.kind = PROGRESS_JSON;
    } else if (!options->quiet && isatty(STDERR_FILENO)) {
        progress.kind = PROGRESS_TTY;
    }
    return progress;
}

static double seconds_left(const ProgressFigures *figures) {
    double left = INFINITY;
    if (figures->target_samples && figures->samples > 0)
        left = figures->seconds * ((double)figures->target_samples / figures->samples - 1);
    /* The error falls with the square root of the time, or a little faster. */
    if (figures->target_error_percent > 0 && figures->error_percent < INFINITY)
        left = figures->seconds * (pow(figures->error_percent / figures->target_error_percent, 2) - 1);
    if (figures->target_seconds > 0) left = fmin(left, figures->target_seconds - figures->seconds);
    return fmax(left, 0);
}

static void report_terminal(Progress *progress, const ProgressFigures *figures) {
    if (figures->done) {
        if (progress->line) fputs("\r\033[K", stderr);
        return;
    }
    char line[200], target[32] = "", reached[64] = "", left[32] = "";
    if (figures->target_samples) snprintf(target, sizeof target, " of %" PRIu64, figures->target_samples);
    if (figures->error_percent < INFINITY)
        snprintf(reached, sizeof reached, "error about %.2g %%, ", figures->error_percent);
    if (seconds_left(figures) < INFINITY)
        snprintf(left, sizeof left, ", %.0f s left", ceil(seconds_left(figures)));
    snprintf(line, sizeof line, "%s%.0f%s samples, %.1f Mpaths/s%s", reached, figures->samples, target,
             1e-6 * (double)figures->paths / fmax(figures->seconds, 1e-9), left);
    /* The line is cut to the terminal's width. Otherwise it would wrap and scroll at each report. */
    fprintf(stderr, "\r%.*s\033[K", terminal_columns(STDERR_FILENO) - 1, line);
    progress->line = true;
}

static void report_json(const ProgressFigures *figures) {
    Json json = json_begin();
    json_flag(&json, "done", figures->done);
    json_number(&json, "samples", figures->samples);
    json_count(&json, "paths", figures->paths);
    json_seconds(&json, "seconds", figures->seconds);
    json_seconds(&json, "startup_seconds", figures->startup_seconds);
    json_number(&json, "paths_per_s", (double)figures->paths / fmax(figures->seconds, 1e-9));
    if (figures->error_percent < INFINITY) {
        json_number(&json, "error_percent", figures->error_percent);
        json_number(&json, "noise_percent", figures->noise_percent);
    }
    if (figures->done) {
        json_count(&json, "rejected", figures->rejected);
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

void progress_report(Progress *progress, const ProgressFigures *figures) {
    if (progress->kind == PROGRESS_NONE) return;
    if (!figures->done && figures->seconds - progress->last < 0.1) return;
    progress->last = figures->seconds;
    if (progress->kind == PROGRESS_TTY) report_terminal(progress, figures);
    if (progress->kind == PROGRESS_JSON) report_json(figures);
}
