/* The state that the window's user has set. The controls and the overlay write it; everything that draws
 * reads it. */
#pragma once

#include "scene/scene.h"
#include "view/day.h"
#include "view/exposure.h"

/* The names of methods, as on the command line. An empty name means auto. */
typedef struct MethodNames {
    char sky[48], further[48], light[48], sequence[48], sun_disk[48];
} MethodNames;

/* Returns a name as the renderer takes it, which is NULL for auto. */
static inline const char *method_name(const char *name) {
    return *name ? name : NULL;
}

enum { MOST_SIDES = 2 };

/* A message to the user. The next message replaces it. */
typedef struct Notice {
    char text[4096];
    bool failed;
    /* The time of the message. */
    double said;
} Notice;

/* Wishes that are fulfilled once, at the next frame. */
typedef struct Wishes {
    bool quit, save, copy, link;
    /* To open the panel or to close it. */
    bool panel;
    /* To list the scenes that can be opened. */
    bool list;
    /* The path of a scene to open, owned; NULL if there is none. */
    char *open;
} Wishes;

typedef struct ViewState {
    /* The scene of the file and the command line. It owns the path. */
    Scene file;
    /* Whether the scene was opened in the window, so that the command line's settings are not its own. */
    bool opened;
    /* The scene as it is now. */
    Scene scene;
    /* The automatic exposure. While it is on, it sets the scene's. */
    AutoExposure exposure;
    MethodNames methods[MOST_SIDES];
    /* Whether the second side is shown. It is right of the divider, whose place is from 0 to 1 of the width.
     */
    bool split;
    double divider;
    /* Whether the second side has a sun of its own. */
    bool own_sun;
    double own_elevation_deg, own_azimuth_deg;
    /* Whether the difference of the sides is shown, in false colours. Their ends are at this share of the
     * mean radiance.
     */
    bool difference;
    double difference_percent;
    bool overlay, inspect;
    /* Whether the panel is open, as the overlay says. A closed panel is a bar of figures. */
    bool panel_open;
    /* Whether the list of keys is shown, and whether the hint for a first run is. */
    bool help, hint;
    /* Whether a day is played. */
    bool playing;
    Day day;
    double hours_per_second;
    /* Whether iTime runs, and its value. */
    bool clock_running;
    double clock_seconds;
    /* Whether the user types the place of a side's sun. */
    bool prompting;
    int prompt_side;
    char prompt[64];
    /* Places of the pointer, in pixels from the top left corner: now, when the left button was last down, and
     * when it was pressed. */
    double pointer[2], dragged[2], pressed[2];
    bool left_down;
    /* Whether the left button was pressed at all. Before that, iMouse is what the scene's settings say. */
    bool clicked;
    Wishes wishes;
    Notice notice;
} ViewState;

void view_notice(ViewState *state, const char *format, ...) __attribute__((format(printf, 2, 3)));
void view_failure(ViewState *state, const char *text);

/* Says whether there is a notice to show. A notice is shown for some seconds, and a failure until the next
 * notice. */
bool view_has_notice(const ViewState *state);

/* Says whether an error is about what the user asked for, and not about the machine. */
bool view_is_refusal(const Error *error);

/* Returns the scene of a side. The second side may have a sun of its own. */
Scene view_scene(const ViewState *state, int side);

/* Sets the place of a side's sun. If the second side has no sun of its own, both sides have that of the
 * first. The elevation is kept within [-90, 90], and the azimuth is wrapped into [0, 360). */
void view_set_sun(ViewState *state, int side, double elevation_deg, double azimuth_deg);

/* Turns a side's sun from where it is. */
void view_turn_sun(ViewState *state, int side, double elevation_deg, double azimuth_deg);

/* Wishes to open a scene. The last wish holds. */
void view_open(ViewState *state, const char *path);

/* Sets the exposure by hand, which turns the automatic one off. */
void view_set_exposure(ViewState *state, double exposure_ev);

/* Returns the side that is shown at column x of a picture of this width. */
int view_side_at(const ViewState *state, double x, int width);

/* Gives the second side a sun of its own, or takes it away. At first it stands where the other sun is. */
void view_own_sun(ViewState *state, bool own);

/* Sets `mouse` to Shadertoy's iMouse in a picture of this height. It has the place where the left button is
 * or was last down, and the place where it was pressed, which is negative if the button is up. Both count
 * from the bottom left corner.
 */
void view_mouse(const ViewState *state, int height, double mouse[4]);

/* Applies one of the scene's presets. The exposure is that of the file, unless the preset sets it. */
void view_choose_preset(ViewState *state, const char *name);

/* Applies one of the paper's four times, 0 to 3. This is the scene's preset of that name, if there is one;
 * otherwise the sun and the exposure of the paper's scene. */
void view_choose_time(ViewState *state, int time);

/* Prints camera and sun as annotations of a scene. */
void view_annotations(const ViewState *state, char *out, size_t size);
