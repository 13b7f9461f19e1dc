/* Shows the progress of a long measurement on standard error: a bar on a terminal, a line every 5 seconds
 * elsewhere, or JSON lines. */
#pragma once

#include "cmd/progress.h"

typedef struct Gauge {
    Progress progress;
    /* In seconds of clock_seconds(). */
    double start;
    /* What was reported last. */
    double share;
    char words[120];
} Gauge;

Gauge gauge_start(const Options *options);

/* The report function of a Monitor. It prints if it is time (progress_due()). */
void gauge_report(void *gauge, double share, const char *words);

/* The function of a SkyWatch over the tables that what was reported last needs: reports that once more, with
 * their share. Returns false if the user has interrupted the program. */
bool gauge_watch_tables(void *gauge, double share);

/* Clears the bar, or prints the last JSON line. Nothing is reported after that. */
void gauge_end(Gauge *gauge, bool interrupted);
