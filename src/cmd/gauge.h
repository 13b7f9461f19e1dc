/* How far a long measurement is: a bar on a terminal, or JSON lines, on standard error. */
#pragma once

#include "cmd/options.h"

typedef struct Gauge {
    bool json, bar;
    double start, last; /* seconds, by clock_seconds() */
    bool line;          /* an unfinished line stands on the terminal */
} Gauge;

Gauge gauge_start(const Options *options);

/* A Monitor's report: at most ten times a second. */
void gauge_report(void *gauge, double share, const char *words);

/* Clears the bar; the last JSON line. */
void gauge_end(Gauge *gauge, bool interrupted);
