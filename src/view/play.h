/* Plays a file that paints by itself (render/toy.h) in the window. */
#pragma once

#include "render/toy.h"
#include "view/state.h"
#include "view/view_params.h"

/* The moment of the next frame, in a picture of this height. In a record it follows from the frame's number.
 */
ToyMoment play_moment(const Toy *toy, const ViewParams *params, const ViewState *state, int height);

/* What was said of a program. */
typedef struct PlayNotes {
    GLuint program;
    /* When its loops were looked at last, and whether it was said that they are cut. */
    double looked;
    bool said_cut;
} PlayNotes;

/* Says in the window and on standard error, once for each program, what it does not get, and that the driver
 * cuts its loops. */
MUST_CHECK bool play_say(PlayNotes *notes, const Toy *toy, ViewState *state, Error *error);
