/* What the window shows: one or two pictures of a scene, or a Shadertoy program. */
#pragma once

#include "render/toy.h"
#include "view/display.h"
#include "view/inspect.h"
#include "view/pane.h"
#include "view/save.h"
#include "view/view_params.h"
#include "view/watch.h"

typedef struct Picture {
    const ViewParams *params;
    const Context *context;
    /* The window's size in pixels. */
    int width, height;
    Pane panes[MOST_SIDES];
    /* Shown in place of the panes if its program is not empty. */
    Toy toy;
    Inspect inspect;
    /* The last scene and methods that the panes did not refuse. */
    Scene good_scene;
    MethodNames good_methods[MOST_SIDES];
    /* Whether the scene mentions iTime and iMouse. */
    bool wants_time, wants_mouse;
    /* The time of the last change. */
    double changed;
    /* The number of pictures that were begun. */
    int pictures;
} Picture;

/* Fails with STATUS_SCENE if a Shadertoy program does not compile. Scenes are compiled by the first update.
 */
MUST_CHECK bool picture_create(Picture *picture, const ViewParams *params, const Context *context,
                               ViewState *state, Error *error);
void picture_destroy(Picture *picture);

/* Follows the state. If a change is refused, the state goes back to what it was, and `refusal` has the
 * reason. If nothing is refused, the status of `refusal` is STATUS_DONE. A refused first scene is a failure.
 */
MUST_CHECK bool picture_update(Picture *picture, ViewState *state, Error *refusal, Error *error);

/* Draws for some milliseconds. Sets `drew` to whether there was anything left to draw. */
MUST_CHECK bool picture_draw(Picture *picture, const ViewState *state, bool *drew, Error *error);

/* Says whether the next frame should come at once, because something changed lately or the sky is computed.
 */
bool picture_hurries(const Picture *picture, const ViewState *state);

/* Says whether nothing is left to draw. */
bool picture_rests(const Picture *picture, const ViewState *state);

/* Says whether the picture is a frame to be recorded, when `done` frames were recorded before. */
bool picture_has_frame(const Picture *picture, const ViewState *state, int done);

/* What a side has to show. `scene` is that side's. */
PaneParams picture_pane_params(const Picture *picture, const ViewState *state, int side, const Scene *scene);

DisplayParams picture_display(const Picture *picture, const ViewState *state);

/* Fills in the figures of the pictures, and those of the pixel under the pointer if they are shown. */
MUST_CHECK bool picture_figures(Picture *picture, const ViewState *state, ViewFigures *figures, Error *error);

/* Says whether everything shown is at rest and has a group of samples, so that it can be saved. */
bool picture_is_whole(const Picture *picture, const ViewState *state);

/* Saves what is shown, as save_picture() does. */
MUST_CHECK bool picture_save(const Picture *picture, const ViewState *state, const char *name, bool exr,
                             Error *error);
