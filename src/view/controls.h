/* Keys and mouse: each event changes the view's state. What the keys do stands in one table in controls.c,
 * which the help is made from. */
#pragma once

#include "view/state.h"
#include "view/window.h"

typedef enum Drag { DRAG_NONE, DRAG_ORBIT, DRAG_LOOK, DRAG_PAN, DRAG_SUN, DRAG_DIVIDER } Drag;

typedef struct Controls {
    Drag drag;
    int drag_button;
    int drag_side; /* whose sun is dragged */
    double last[2];
    bool held[6]; /* W A S D E Q */
    bool s_drags; /* the S that is held has become a drag of the sun */
    double s_since, eye_before_s[3], target_before_s[3];
} Controls;

/* A line of the help: "right drag", "move the sun". NULL past the end. */
typedef struct ControlsHelp {
    const char *keys, *what;
} ControlsHelp;
const ControlsHelp *controls_help(int index);

/* `width` and `height` are the picture's. */
void controls_event(Controls *controls, ViewState *state, const WindowEvent *event, int width, int height);

/* Keys that are held move the camera; `seconds` since the last call. */
void controls_fly(Controls *controls, ViewState *state, double seconds);

/* All keys and buttons as if let go of. */
void controls_release(Controls *controls);
