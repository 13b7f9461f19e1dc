/* The window: one loop that hears events, draws for some milliseconds, and shows what there is. */
#pragma once

#include "view/state.h"

#include <stdint.h>

typedef struct ViewParams {
    /* Reads the scene's file with the command line's settings over it: at the start, and after each edit. */
    bool (*load)(const void *data, Scene *scene, Error *error);
    const void *data;
    const char *path;    /* of the scene */
    const char *library; /* folder of the GLSL library */
    /* The same where it was named on the command line, to be said in the command that a picture is saved
     * with. */
    const char *glsl_dir;
    MethodNames methods; /* of the left side; the right side's begin as cosine and random */
    int width, height;   /* 0 for the scene's */
    unsigned seed;
    int max_hits;
    uint64_t samples;   /* a pixel, after which a picture rests; 0 is many */
    const char *record; /* folder for the frames of a day, which is played once; NULL for none */
    bool (*stop)(void);
} ViewParams;

/* Until the window is closed. STATUS_NO_GL without a display, STATUS_SCENE for a scene that does not compile
 * at the start. */
MUST_CHECK bool view_run(const ViewParams *params, Error *error);
