/* Keeps the window alive while the worker is busy: it shows the last picture with a line that says how long
 * the compilation has taken, and it can be closed. */
#pragma once

#include "view/display.h"
#include "view/overlay.h"
#include "view/view_params.h"
#include "view/worker.h"

typedef struct Busy {
    const ViewParams *params;
    Window *window;
    const Display *display;
    Overlay *overlay;
    Worker worker;
    /* A copy of the last picture without the overlay, and when it was made. */
    Target copy;
    double copied;
    /* Whether the line was shown. */
    bool shown;
} Busy;

/* Starts the worker. The parts of the window are set by the caller before. */
MUST_CHECK bool busy_start(Busy *busy, Error *error);
void busy_stop(Busy *busy);

/* Copies the picture that is on framebuffer 0, now and then. */
MUST_CHECK bool busy_copy(Busy *busy, Error *error);

/* Lets the worker do the task and returns what it returned. If the user leaves in the meantime and the worker
 * does not come to an end soon, the program ends (ViewParams.leave). */
MUST_CHECK bool busy_run(Busy *busy, WorkerTask *task, void *data, Error *error);
