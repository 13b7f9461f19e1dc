/* The panel and the notes over the picture, by Dear ImGui: the one part that is C++, behind this header. */
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

#include "view/figures.h"
#include "view/window.h"

typedef struct Overlay Overlay;

/* NULL (STATUS_FAILURE) where ImGui cannot draw on this OpenGL. */
Overlay *overlay_create(Window *window, Error *error);
void overlay_destroy(Overlay *overlay);

/* Tells it an event; whether that was for the panel alone. `panel`: whether that is still wanted. */
bool overlay_event(Overlay *overlay, const WindowEvent *event, bool panel);

/* Lays out the panel for this frame; what the user does there goes into `state`. */
void overlay_build(Overlay *overlay, ViewState *state, const ViewFigures *figures);

/* Draws it on framebuffer 0. */
void overlay_draw(Overlay *overlay);

#ifdef __cplusplus
}
#endif
