/* Shows the progress of a long measurement on standard error: a bar on a terminal, or JSON lines. */
#pragma once

#include "cmd/options.h"

typedef struct Gauge {
    bool json, bar;
    /* In seconds of clock_seconds(). */
    double start, last;
    /* Whether there is an unfinished line on the terminal. */
    bool line;
} Gauge;

Gauge gauge_start(const Options *options);

/* The report function of a Monitor. It prints at most ten times a second. */
void gauge_report(void *gauge, double share, const char *words);

/* Clears the bar, or prints the last JSON line. */
void gauge_end(Gauge *gauge, bool interrupted);
