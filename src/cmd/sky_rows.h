/* The rows of `sky --at`: height_m,sun_el_deg,view_el_deg,az_deg, then R,G,B. */
#pragma once

#include "base/text.h"

typedef struct SkyRow {
    double height_m, sun_el_deg, view_el_deg, az_deg; /* azimuth from the sun's */
    double radiance[3];
    char words[4][32]; /* as they were written */
} SkyRow;

typedef struct SkyRows {
    SkyRow *rows; /* owned */
    size_t count;
    Text comments; /* the lines that start with #, each with its end */
} SkyRows;

/* A header line and lines that start with # are allowed, further columns ignored. A bad row is an error with
 * its line. */
MUST_CHECK bool sky_rows_read(SkyRows *rows, const char *path, Error *error);
void sky_rows_free(SkyRows *rows);

/* The comments, a header, and each row with R,G,B in full precision. */
void sky_rows_print(const SkyRows *rows, Text *out);
