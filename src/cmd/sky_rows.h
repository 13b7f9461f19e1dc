/* The rows of `sky --at`: height_m,sun_el_deg,view_el_deg,az_deg, then R,G,B. */
#pragma once

#include "base/text.h"

typedef struct SkyRow {
    /* The azimuth is measured from the sun's. */
    double height_m, sun_el_deg, view_el_deg, az_deg;
    double radiance[3];
    /* The numbers as they were written. */
    char words[4][32];
} SkyRow;

typedef struct SkyRows {
    /* Owned. */
    SkyRow *rows;
    size_t count;
    /* The lines that start with #, each with its end. */
    Text comments;
} SkyRows;

/* Reads the rows of a file. A header line and lines that start with # are allowed, and further columns are
 * ignored. The error for a bad row names its line. */
MUST_CHECK bool sky_rows_read(SkyRows *rows, const char *path, Error *error);
void sky_rows_free(SkyRows *rows);

/* Prints the comments, a header, and each row with R,G,B in full precision. */
void sky_rows_print(const SkyRows *rows, Text *out);
