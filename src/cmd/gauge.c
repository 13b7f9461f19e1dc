#include "cmd/gauge.h"

#include "base/clock.h"
#include "base/json.h"
#include "cmd/interrupt.h"
#include "cmd/terminal.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

enum { BAR = 24, WIDE = 72 };

Gauge gauge_start(const Options *options) {
    return (Gauge){.progress = progress_start(options), .start = clock_seconds()};
}

static void print_json(const Gauge *gauge, const char *words, double seconds) {
    Json json = json_begin();
    json_flag(&json, "done", false);
    json_number(&json, "share", gauge->share);
    json_seconds(&json, "seconds", seconds);
    json_text(&json, "at", words);
    json_end(&json, stderr);
}

static void print_words(Gauge *gauge, const char *words, double seconds) {
    char line[240];
    int filled = (int)lround(BAR * fmin(fmax(gauge->share, 0), 1));
    /* On a narrow terminal the words are worth more than the bar. */
    if (gauge->progress.kind == PROGRESS_TTY && terminal_columns(STDERR_FILENO) >= WIDE)
        snprintf(line, sizeof line, "[%.*s%.*s] %3.0f %%, %.0f s, %s", filled, "########################",
                 BAR - filled, "                        ", 100 * gauge->share, seconds, words);
    else
        snprintf(line, sizeof line, "%.0f %%, %.0f s, %s", 100 * gauge->share, seconds, words);
    progress_words(&gauge->progress, line);
}

static void print(Gauge *gauge, const char *words) {
    double seconds = clock_seconds() - gauge->start;
    if (!progress_due(&gauge->progress)) return;
    if (gauge->progress.kind == PROGRESS_JSON)
        print_json(gauge, words, seconds);
    else
        print_words(gauge, words, seconds);
}

void gauge_report(void *state, double share, const char *words) {
    Gauge *gauge = state;
    gauge->share = share;
    snprintf(gauge->words, sizeof gauge->words, "%s", words);
    print(gauge, words);
}

bool gauge_watch_tables(void *state, double share) {
    Gauge *gauge = state;
    char words[160];
    snprintf(words, sizeof words, "%s%sthe sky's tables, %.0f %%", gauge->words, *gauge->words ? ": " : "",
             floor(100 * share));
    if (share < 1) print(gauge, words);
    return !interrupt_requested();
}

void gauge_end(Gauge *gauge, bool interrupted) {
    ProgressKind kind = gauge->progress.kind;
    progress_clear(&gauge->progress);
    gauge->progress.kind = PROGRESS_NONE;
    if (kind != PROGRESS_JSON) return;
    Json json = json_begin();
    json_flag(&json, "done", true);
    json_seconds(&json, "seconds", clock_seconds() - gauge->start);
    json_flag(&json, "interrupted", interrupted);
    json_end(&json, stderr);
}
