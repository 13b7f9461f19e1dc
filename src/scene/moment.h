/* A moment as ISO 8601 writes it, such as 2026-06-21T20:30+02:00. */
#pragma once

#include "base/error.h"
#include "base/text.h"

typedef struct Moment {
    /* Seconds of UTC since 1970-01-01T00:00Z, without leap seconds. */
    double utc_s;
    /* How far the clock is ahead of UTC. */
    double zone_s;
} Moment;

/* Reads YYYY-MM-DDTHH:MM[:SS] and then Z or +HH:MM or -HH:MM, for the years 1900 to 2100. STATUS_USAGE says
 * what is missing or outside. */
MUST_CHECK bool moment_parse(const char *name, const char *text, Moment *moment, Error *error);

/* Appends "2026-06-21", "20:30" and "+02:00" of the moment's own clock. */
void moment_print_date(const Moment *moment, Text *out);
void moment_print_time(const Moment *moment, Text *out);
void moment_print_zone(const Moment *moment, Text *out);

/* The moment at which the same clock showed 00:00 of the same day. */
Moment moment_midnight(const Moment *moment);
