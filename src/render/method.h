/* The methods by name: what --sky, --light and --sequence take, and which GLSL file each one is. */
#pragma once

#include "base/error.h"

typedef enum MethodFamily { METHOD_SKY, METHOD_LIGHT, METHOD_SEQUENCE, METHOD_FAMILIES } MethodFamily;

typedef struct Method {
    MethodFamily family;
    const char *name;
    const char *file; /* in the GLSL library */
    const char *about;
} Method;

/* A method with its numbers. */
typedef struct MethodChoice {
    const Method *method;
    char text[48];   /* "paper:16x4" */
    int counts[2];   /* paper: N and M */
    double level;    /* uniform: L */
    long iterations; /* of loops, a call: paper N + N M */
} MethodChoice;

/* The table; NULL past the end. */
const Method *method_get(int index);

/* The family's default: the cheapest that is accurate enough, once there is a choice. */
const char *method_default(MethodFamily family);

/* `text` as on the command line; NULL or "auto" is the default. STATUS_USAGE names what is known. */
MUST_CHECK bool method_choose(MethodChoice *choice, MethodFamily family, const char *text, Error *error);
