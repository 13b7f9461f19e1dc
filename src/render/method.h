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
    char text[48];   /* in full: "table:gauss:8" */
    bool table;      /* a sky: `method` fills a table that is looked up */
    int columns, rows; /* of the table's half above the horizon and of that below; 0 is by the sun */
    int counts[2];   /* paper: N and M; gauss: nodes a segment */
    double level;    /* uniform: L */
    long iterations; /* of loops, a call of the method: paper N + N M */
} MethodChoice;

/* The table; NULL past the end. */
const Method *method_get(int index);

/* What "auto" is, in words. */
const char *method_default(MethodFamily family);

/* `text` as on the command line; NULL or "auto" is the default, for a sky the table. STATUS_USAGE names what
 * is known. */
MUST_CHECK bool method_choose(MethodChoice *choice, MethodFamily family, const char *text, Error *error);

/* The sky for `text` NULL or "auto": the table, or its direct method where `paths` would not repay filling
 * one, or where the observer is above the air and the table is coarse. */
MUST_CHECK bool method_choose_sky(MethodChoice *choice, const char *text, double paths, bool above_air,
                                  Error *error);

/* The light method for `text` NULL or "auto": control where the sky is a table and the scene says what may
 * block it
 * (`bounds`), else cosine. */
MUST_CHECK bool method_choose_light(MethodChoice *choice, const char *text, bool table, bool bounds,
                                    Error *error);
