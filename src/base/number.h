/* Strict reading of numbers. */
#pragma once

#include "base/error.h"

/* Reads all of `text` as a finite number, such as "1e-3" or "-2.5". Returns false if it is anything else. */
bool number_parse(const char *text, double *value);

/* Reads all of `text` as a whole number from 0 to 2^53. Returns false if it is anything else. */
bool count_parse(const char *text, unsigned long long *value);

/* Reads a number as number_parse() does. STATUS_USAGE says "NAME: 'VALUE' is not a number, and one
 * from MIN to MAX is needed" or "NAME: VALUE is outside the range from MIN to MAX". */
MUST_CHECK bool number_parse_range(const char *name, const char *text, double min, double max, double *value,
                                   Error *error);
