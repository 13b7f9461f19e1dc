/* Fulfils the user's wishes that are fulfilled once: to copy a text, and to save the picture. */
#pragma once

#include "view/picture.h"
#include "view/window.h"

/* Copies camera and sun as annotations, or the command that opens what is shown. */
void wishes_copy(ViewState *state, const ViewParams *params, Window *window);

/* Saves the picture as soon as it is at rest. A file that cannot be written is reported, and the window stays
 * open. */
void wishes_save(ViewState *state, const Picture *picture);
