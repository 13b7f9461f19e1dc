/* Writes frames into a folder (--record), each from the picture that is done, whatever time it took. A
 * scene's frames are those of a day, and those of a file that paints by itself follow its iTime. */
#pragma once

#include "view/picture.h"

/* How many seconds a file that paints by itself is recorded if the user does not say how many frames. */
enum { RECORD_SECONDS = 10 };

/* Saves the picture as the next frame if it is done, moves the sun on, and closes the window behind the last
 * frame. `done` is the number of frames so far. */
MUST_CHECK bool record_frame(int *done, const Picture *picture, ViewState *state, Error *error);

/* Moves the sun on through the day. */
void record_advance_day(ViewState *state, double hours);
