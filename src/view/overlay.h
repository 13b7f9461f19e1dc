/* The panel and the notes over the picture, drawn by Dear ImGui. The files behind this header are the only
 * part of the host in C++. */
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

#include "view/figures.h"
#include "view/window.h"

typedef struct Overlay Overlay;

/* The panel stands where it was left, and `state` says whether a hint for a first run is due. What is to be
 * remembered is written when it has changed (view/remember.h). Returns NULL and STATUS_FAILURE if ImGui
 * cannot draw with this OpenGL. */
Overlay *overlay_create(Window *window, ViewState *state, Error *error);
void overlay_destroy(Overlay *overlay);

/* Passes an event to the overlay. Returns whether the event was for the panel or the list of keys alone. */
bool overlay_event(Overlay *overlay, const WindowEvent *event, ViewState *state);

/* Lays out the panel for this frame. What the user does there changes `state`. */
void overlay_build(Overlay *overlay, ViewState *state, const ViewFigures *figures);

/* Draws one line on framebuffer 0, in place of the overlay that was laid out. */
void overlay_say(Overlay *overlay, const char *line);

/* Draws the overlay on framebuffer 0. */
void overlay_draw(Overlay *overlay);

#ifdef __cplusplus
}
#endif
