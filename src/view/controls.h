/* Keys and mouse. Each event changes the view's state. */
#pragma once

#include "view/state.h"
#include "view/window.h"

typedef enum Drag { DRAG_NONE, DRAG_ORBIT, DRAG_LOOK, DRAG_PAN, DRAG_SUN, DRAG_DIVIDER } Drag;

typedef struct Controls {
    Drag drag;
    int drag_button;
    /* The side whose sun is dragged. */
    int drag_side;
    double last[2];
    /* Whether W, A, S, D, E and Q are held. */
    bool held[6];
    /* Whether S is held to drag the sun, not to fly. */
    bool s_drags;
    double s_since, eye_before_s[3], target_before_s[3];
} Controls;

/* Handles an event. `width` and `height` are those of the picture. */
void controls_event(Controls *controls, ViewState *state, const WindowEvent *event, int width, int height);

/* Moves the camera by the keys that are held. `seconds` is the time since the last call. */
void controls_fly(Controls *controls, ViewState *state, double seconds);

/* Acts as if all keys and buttons were released. */
void controls_release(Controls *controls);
