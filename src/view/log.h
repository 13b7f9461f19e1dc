/* A log of what happens in the window, for programs: one JSON object a line on standard error. It is on if
 * the user gives --progress json. */
#pragma once

#include <stdbool.h>

/* Turns the log on or off. Nothing is written while it is off. */
void log_enable(bool on);

/* Starts a line with the event's name and the time, in seconds of the clock CLOCK_MONOTONIC, which tests can
 * read too. log_end() ends the line. */
void log_begin(const char *event);

/* A value that is not finite is written as null. */
void log_number(const char *name, double value);
void log_text(const char *name, const char *value);
void log_end(void);
