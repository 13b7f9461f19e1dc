/* Settings' values: one number, or several with commas. */
#pragma once

#include "base/error.h"

/* Parses `count` numbers "a", "a,b,c" or "a,b,c,d" in [min, max]; one number alone sets all three.
 * STATUS_USAGE names `name` and the range. `values` is untouched on failure. */
MUST_CHECK bool value_parse(const char *name, const char *text, int count, double min, double max,
                            double *values, Error *error);
