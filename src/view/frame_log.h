/* The log's line for each picture that the window shows. */
#pragma once

#include "view/figures.h"
#include "view/state.h"

typedef struct FrameLog {
    /* From 0. */
    int number;
    /* The number of pictures that were begun. */
    int pictures;
    int width, height;
    /* From the first event that the picture answers to the picture; 0 where there was none. */
    double latency_s;
    /* Whether nothing is left to draw. */
    bool rests;
} FrameLog;

void frame_log(const FrameLog *frame, const ViewState *state, const ViewFigures *figures);
