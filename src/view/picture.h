/* What the window shows: a scene's picture or two, or a Shadertoy program. */
#pragma once

#include "view/display.h"
#include "view/inspect.h"
#include "view/pane.h"
#include "view/save.h"
#include "view/toy.h"
#include "view/view.h"
#include "view/watch.h"

typedef struct Picture {
    const ViewParams *params;
    const Context *context;
    int width, height; /* of the window, pixels */
    Pane panes[MOST_SIDES];
    Toy toy; /* in place of the panes, if its program is not empty */
    Inspect inspect;
    Scene good_scene; /* what the panes were told last that they did not refuse */
    MethodNames good_methods[MOST_SIDES];
    bool wants_time, wants_mouse; /* whether the scene names iTime, iMouse */
    double changed;               /* when */
    int pictures;                 /* begun so far */
} Picture;

/* STATUS_SCENE where a Shadertoy program does not compile; scenes are compiled with the first update. */
MUST_CHECK bool picture_create(Picture *picture, const ViewParams *params, const Context *context,
                               ViewState *state, Error *error);
void picture_destroy(Picture *picture);

/* Tells it what the state is now. What is refused goes back to what it was, and is told in `refusal` (status
 * STATUS_DONE where there is none); only the first scene must not be. */
MUST_CHECK bool picture_update(Picture *picture, ViewState *state, Error *refusal, Error *error);

/* Draws for some milliseconds; `drew` tells whether there was anything left to draw. */
MUST_CHECK bool picture_draw(Picture *picture, const ViewState *state, bool *drew, Error *error);

/* Whether something changed so lately that the next frame should come at once. */
bool picture_moves(const Picture *picture);

/* Whether there is nothing left to draw. */
bool picture_rests(const Picture *picture, const ViewState *state);

/* Reads the scene's file again. What was set in the window stays; a file that is broken changes nothing. */
MUST_CHECK bool picture_reload(Picture *picture, ViewState *state, Error *error);

/* Adds the files that it is made of, rows of spheres among them. */
void picture_watch(Picture *picture, const ViewState *state, Watch *watch);

DisplayParams picture_display(const Picture *picture, const ViewState *state);

/* Its figures, and those of the pixel under the pointer if they are wanted. */
MUST_CHECK bool picture_figures(Picture *picture, const ViewState *state, ViewFigures *figures, Error *error);

/* Whether all that is shown has a group of samples at rest, and so can be saved. */
bool picture_is_whole(const Picture *picture, const ViewState *state);

/* As save_picture() does. */
MUST_CHECK bool picture_save(const Picture *picture, const ViewState *state, const char *name, bool exr,
                             Error *error);
