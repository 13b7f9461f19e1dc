/* The methods by name: what --sky, --light and --sequence take, and which GLSL file each one is. */
#pragma once

#include "base/error.h"

typedef enum MethodFamily {
    METHOD_SKY,
    METHOD_LIGHT,
    METHOD_SEQUENCE,
    METHOD_SUN,
    METHOD_FAMILIES
} MethodFamily;

typedef struct Method {
    MethodFamily family;
    const char *name;
    const char
        *file; /* in the GLSL library; a sky's defines sky_radiance() or, if it integrates, sky_sums() */
    bool integrates; /* a sky that sums along the ray: asked anew each time, or to fill a table */
    const char *about;
} Method;

/* A method with its numbers. */
typedef struct MethodChoice {
    const Method *method;
    char text[48];        /* in full: "table:gauss:8" */
    bool table;           /* a sky: `method` fills a table that is looked up */
    int columns, rows;    /* of the table's half above the horizon and of that below */
    double table_percent; /* where above 0, the size is by the sun: no more than this error is the table's */
    char why[200];        /* that auto took it; empty where it was asked for */
    int counts[2];        /* paper: N and M; gauss: nodes a segment */
    double level;         /* uniform: L */
    long iterations;      /* of loops, a call of the method: paper N + N M */
} MethodChoice;

/* The table; NULL past the end. */
const Method *method_get(int index);

/* What "auto" is, in words. */
const char *method_default(MethodFamily family);

/* `text` as on the command line; NULL or "auto" is the default, for a sky the table (choice/auto.h knows
 * better). STATUS_USAGE names what is known. */
MUST_CHECK bool method_choose(MethodChoice *choice, MethodFamily family, const char *text, Error *error);
