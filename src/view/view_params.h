/* What the window is opened with. */
#pragma once

#include "view/state.h"

#include <stdint.h>

typedef struct ViewParams {
    /* Reads the scene's file with the command line's settings over it: at the start, and after each edit. */
    bool (*load)(const void *data, Scene *scene, Error *error);
    const void *data;
    /* The scene's file. */
    const char *path;
    /* The folder of the GLSL library. */
    const char *library;
    /* The same folder if the command line names it, for the command in the metadata of saved pictures.
     * Otherwise NULL. */
    const char *glsl_dir;
    /* The methods of the left side. The right side begins with cosine and random. */
    MethodNames methods;
    /* The preset that the command line names, or NULL. */
    const char *preset;
    /* Whether the command line sets the exposure. */
    bool exposure_set;
    /* 0 means the scene's size. */
    int width, height;
    unsigned seed;
    int max_hits;
    /* A picture is done after this number of samples of each pixel. 0 means a large number. */
    uint64_t samples;
    /* The folder for frames (view/record.h). NULL means that nothing is recorded. */
    const char *record;
    /* The number of frames, and frames a second. 0 means the usual. */
    int frames;
    double frame_rate;
    bool (*stop)(void);
    /* Ends the program while a thread is in the middle of something, because the user closed the window or,
     * if `stopped`, because stop() says so. It does not return. */
    void (*leave)(bool stopped);
} ViewParams;

/* Frames a second of a record if the user does not say. */
enum { RECORD_RATE = 25 };

/* Seconds from one frame of a record to the next. */
static inline double view_frame_step(const ViewParams *params) {
    return 1 / (params->frame_rate > 0 ? params->frame_rate : RECORD_RATE);
}
