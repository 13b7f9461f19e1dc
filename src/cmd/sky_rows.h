/* The rows of `sky --at`: height_m,sun_el_deg,view_el_deg,az_deg, then the columns of the answer. */
#pragma once

#include "base/text.h"

typedef struct SkyRow {
    /* The azimuth is measured from the sun's. */
    double height_m, sun_el_deg, view_el_deg, az_deg;
    /* The answer, one value for each column. There is room for whole threes. */
    double *values;
    /* How many of the columns are computed. */
    int done;
    /* The numbers as they were written. */
    char words[4][32];
} SkyRow;

typedef struct SkyRows {
    /* Owned. */
    SkyRow *rows;
    size_t count;
    /* The names of the columns of the answer, each after a comma, and their number. */
    Text names;
    int columns;
    /* The lines that start with #, each with its end. */
    Text comments;
} SkyRows;

/* Reads the rows of a file. A header line and lines that start with # are allowed, and further columns are
 * ignored. The error for a bad row names its line. */
MUST_CHECK bool sky_rows_read(SkyRows *rows, const char *path, Error *error);
void sky_rows_free(SkyRows *rows);

/* Adds a column to the answer, with values of 0. */
void sky_rows_add(SkyRows *rows, const char *name);

/* How many rows have all columns of their answer. */
size_t sky_rows_done(const SkyRows *rows);

/* Prints the comments, a header, and each row that is done with its answer in full precision. */
void sky_rows_print(const SkyRows *rows, Text *out);
