/* Reads the scene's file: at the start, after an edit, and when another one is opened. */
#pragma once

#include "view/picture.h"

/* Reads the first scene and sets the state that the window begins with. */
MUST_CHECK bool load_first(ViewState *state, const ViewParams *params, Error *error);

/* Reads the scene's file again. What was set in the window stays. A file with an error changes nothing. */
MUST_CHECK bool load_again(Picture *picture, ViewState *state, Error *error);

/* Opens another scene as its file has it. The methods, the sides and the panel stay as they are. A file with
 * an error changes nothing. */
MUST_CHECK bool load_other(Picture *picture, ViewState *state, const char *path, Error *error);

/* Adds all files that the picture is made of to `watch`, also a file of spheres. */
void load_watch(Picture *picture, const ViewState *state, Watch *watch);
