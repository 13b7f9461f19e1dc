/* What happens in the window, for programs: one JSON object a line on standard error, where --progress json
 * asks for it. */
#pragma once

#include <stdbool.h>

/* Starts a line with the event's name and the time (seconds of the clock that tests can read too:
 * CLOCK_MONOTONIC). `log_end` ends it. Nothing is written while it is off. */
void log_enable(bool on);
void log_begin(const char *event);
void log_number(const char *name, double value); /* null where it is not finite */
void log_text(const char *name, const char *value);
void log_end(void);
