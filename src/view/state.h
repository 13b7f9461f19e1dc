/* What the window's user has set: written by the controls and the overlay, read by all that draws. */
#pragma once

#include "scene/scene.h"
#include "view/day.h"

/* As on the command line; empty is auto. */
typedef struct MethodNames {
    char sky[48], light[48], sequence[48], sun_disk[48];
} MethodNames;

/* One of them as the renderer takes it: NULL for auto. */
static inline const char *method_name(const char *name) {
    return *name ? name : NULL;
}

enum { MOST_SIDES = 2 };

/* What is said to the user, until something else is. */
typedef struct Notice {
    char text[4096];
    bool failed;
    double said; /* when */
} Notice;

/* Wishes that are granted once, at the next frame. */
typedef struct Wishes {
    bool quit, save, copy, reload;
} Wishes;

typedef struct ViewState {
    Scene file;  /* as the file and the command line have it; owns the path */
    Scene scene; /* as it is now */
    MethodNames methods[MOST_SIDES];
    bool split; /* the second side is shown right of the divider, 0 to 1 of the width */
    double divider;
    bool own_sun; /* of the second side */
    double own_elevation_deg, own_azimuth_deg;
    bool difference;           /* of the two sides, in false colours ... */
    double difference_percent; /* ... that end at this share of the mean radiance */
    bool overlay, inspect;
    bool playing; /* the day goes by */
    Day day;
    double hours_per_second;
    bool clock_running; /* iTime */
    double clock_seconds;
    bool prompting;  /* for the sun's place ... */
    int prompt_side; /* ... of that side */
    char prompt[64];
    double pointer[2], dragged[2],
        pressed[2]; /* pixels from the top left corner: now, while the left button was last down, and */
    bool left_down; /* where it was pressed */
    /* The left button was pressed once. Before that, iMouse is what the scene's settings say. */
    bool clicked;
    Wishes wishes;
    Notice notice;
} ViewState;

void view_notice(ViewState *state, const char *format, ...) __attribute__((format(printf, 2, 3)));
void view_failure(ViewState *state, const char *text);

/* Whether there is one to show: for some seconds, a failure until the next. */
bool view_has_notice(const ViewState *state);

/* Whether an error is about what was asked for, and not about the machine. */
bool view_is_refusal(const Error *error);

/* The second side's sun where it has its own. */
Scene view_scene(const ViewState *state, int side);

/* Sets a sun's place; 0 is the first side, and the second's unless it has its own. The elevation is kept
 * within [-90, 90], the azimuth is wrapped into [0, 360). */
void view_set_sun(ViewState *state, int side, double elevation_deg, double azimuth_deg);

/* Gives the second side a sun of its own, at first where the other is, or takes it. */
void view_own_sun(ViewState *state, bool own);

/* Shadertoy's iMouse in a picture of this height: where the left button is or was last down, and where it was
 * pressed, negative when it is up; from the bottom left corner. */
void view_mouse(const ViewState *state, int height, double mouse[4]);

/* Applies one of the scene's presets over the exposure of the file. */
void view_choose_preset(ViewState *state, const char *name);

/* One of the paper's four times, 0 to 3: the scene's preset of that name if it has one, else the same sun and
 * exposure. */
void view_choose_time(ViewState *state, int time);

/* Camera and sun as the annotations of a scene. */
void view_annotations(const ViewState *state, char *out, size_t size);
