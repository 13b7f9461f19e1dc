#include "cmd/gauge.h"

#include "base/clock.h"
#include "base/json.h"
#include "cmd/progress.h"
#include "cmd/terminal.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { BAR = 24 };

Gauge gauge_start(const Options *options) {
    ProgressKind kind = progress_start(options).kind;
    return (Gauge){
        .json = kind == PROGRESS_JSON, .bar = kind == PROGRESS_TTY, .start = clock_seconds(), .last = -1};
}

void gauge_report(void *state, double share, const char *words) {
    Gauge *gauge = state;
    double now = clock_seconds(), seconds = now - gauge->start;
    if (now - gauge->last < 0.1) return;
    gauge->last = now;
    if (gauge->json) {
        Json json = json_begin();
        json_flag(&json, "done", false);
        json_number(&json, "share", share);
        json_seconds(&json, "seconds", seconds);
        json_text(&json, "at", words);
        json_end(&json, stderr);
    }
    if (gauge->bar) {
        char line[160];
        int filled = (int)lround(BAR * share);
        snprintf(line, sizeof line, "[%.*s%.*s] %3.0f %%, %.0f s, %s", filled, "########################",
                 BAR - filled, "                        ", 100 * share, seconds, words);
        /* The line is cut to the terminal's width. Otherwise it would wrap and scroll at each report. */
        fprintf(stderr, "\r%.*s\033[K", terminal_columns(STDERR_FILENO) - 1, line);
        gauge->line = true;
    }
}

void gauge_end(Gauge *gauge, bool interrupted) {
    if (gauge->line) fputs("\r\033[K", stderr);
    if (gauge->json) {
        Json json = json_begin();
        json_flag(&json, "done", true);
        json_seconds(&json, "seconds", clock_seconds() - gauge->start);
        json_flag(&json, "interrupted", interrupted);
        json_end(&json, stderr);
    }
    gauge->line = false;
}
