/* The figures of `compare`, for people and for programs. */
#pragma once

#include "base/text.h"
#include "image/compare.h"

/* How the pictures were read, a line each. */
typedef struct CompareSaid {
    Text a, b;
} CompareSaid;

/* Lines of a name and its figures. A picture that holds no radiance has no figures of radiance. */
void compare_print(const Comparison *comparison, const CompareSaid *said);

/* One JSON line of the same names, with `_` for blanks. Where a figure has several numbers, they are an
 * array; an infinite figure is null. `within` says whether all bounds hold. */
void compare_print_json(const Comparison *comparison, const CompareSaid *said, bool within);
