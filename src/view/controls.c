#include "view/controls.h"

#include "base/clock.h"
#include "base/number.h"
#include "base/vec3.h"
#include "view/orbit.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { HELD_W, HELD_A, HELD_S, HELD_D, HELD_E, HELD_Q };
static const int held_keys[] = {GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D, GLFW_KEY_E, GLFW_KEY_Q};

static const ControlsHelp help[] = {
    {"right drag, S + drag", "move the sun"},
    {"arrows, shift + arrows", "the sun by a degree, by a tenth"},
    {"Enter", "type the sun's elevation and azimuth: `-4` or `5 90`"},
    {"1 2 3 4", "the paper's times: sun at 60, 30, 5, -2 degrees"},
    {"T, comma, period", "play a day, slower, faster"},
    {"left drag, wheel", "orbit, nearer and farther"},
    {"shift + drag, middle drag", "look around, shift the view"},
    {"W A S D, E Q", "fly, up and down"},
    {"R", "the scene's own camera"},
    {"C", "copy camera and sun as annotations"},
    {"- =", "exposure"},
    {"V", "two sides with a divider to drag; X exchanges them"},
    {"B", "the right side has a sun of its own, to drag there"},
    {"F, [ ]", "the sides' difference in false colours; their range"},
    {"I", "the pixel under the pointer"},
    {"P", "save what is shown as EXR and PNG"},
    {"Space, Z", "run, reset the scene's iTime"},
    {"H, Esc", "hide the overlay, quit"},
};

const ControlsHelp *controls_help(int index) {
    return index >= 0 && index < (int)(sizeof help / sizeof *help) ? &help[index] : NULL;
}

static int side_at(const ViewState *state, double x, int width) {
    return state->split && x > state->divider * width ? 1 : 0;
}

static void turn_sun(ViewState *state, int side, double elevation_deg, double azimuth_deg) {
    Scene scene = view_scene(state, side);
    view_set_sun(state, side, scene.values.sun.elevation_deg + elevation_deg,
                 scene.values.sun.azimuth_deg + azimuth_deg);
}

/* "-4", "-4 90" or "-4, 90". */
static void end_prompt(ViewState *state) {
    Scene scene = view_scene(state, state->prompt_side);
    double elevation, azimuth = scene.values.sun.azimuth_deg;
    char spaced[sizeof state->prompt], words[2][32] = {"", ""}, more[2];
    snprintf(spaced, sizeof spaced, "%s", state->prompt);
    for (char *comma = spaced; (comma = strchr(comma, ','));) *comma = ' ';
    int count = sscanf(spaced, "%31s %31s %1s", words[0], words[1], more);
    state->prompting = false;
    bool good = (count == 1 || count == 2) && number_parse(words[0], &elevation) && fabs(elevation) <= 90 &&
                (count == 1 || (number_parse(words[1], &azimuth) && fabs(azimuth) <= 360));
    if (good) {
        view_set_sun(state, state->prompt_side, elevation, azimuth);
        scene = view_scene(state, state->prompt_side);
        view_notice(state, "sun %g %g", scene.values.sun.elevation_deg, scene.values.sun.azimuth_deg);
    } else if (count > 0) {
        Error error;
        error_set(&error, STATUS_USAGE, "'%s' is not ELEVATION [AZIMUTH] in degrees", state->prompt);
        view_failure(state, error.text);
    }
}

static void open_prompt(ViewState *state, int side) {
    state->prompting = true;
    state->prompt_side = side;
    state->prompt[0] = 0;
}

static void prompt_text(ViewState *state, unsigned codepoint) {
    size_t length = strlen(state->prompt);
    bool known = codepoint < 128 && strchr("0123456789+-.,e ", (int)codepoint);
    if (!known || !codepoint || length + 1 >= sizeof state->prompt) return;
    state->prompt[length] = (char)codepoint;
    state->prompt[length + 1] = 0;
}

static void prompt_key(ViewState *state, int key) {
    size_t length = strlen(state->prompt);
    if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) end_prompt(state);
    if (key == GLFW_KEY_ESCAPE) state->prompting = false;
    if (key == GLFW_KEY_BACKSPACE && length) state->prompt[length - 1] = 0;
}

static void toggle_day(ViewState *state) {
    state->playing = !state->playing;
    if (state->playing)
        state->day = day_through(state->scene.values.sun.elevation_deg, state->scene.values.sun.azimuth_deg);
    view_notice(state, state->playing ? "a day, %g hours a second" : "the day stands still",
                state->hours_per_second);
}

static void change_speed(ViewState *state, double factor) {
    state->hours_per_second = fmin(fmax(state->hours_per_second * factor, 1.0 / 64), 16);
    view_notice(state, "%g hours a second", state->hours_per_second);
}

static void own_camera(ViewState *state) {
    state->scene.values.camera = state->file.values.camera;
}

static void toggle_split(ViewState *state) {
    state->split = !state->split;
    if (!state->split) state->difference = false;
}

static void toggle_difference(ViewState *state) {
    state->difference = !state->difference;
    if (state->difference) state->split = true;
}

static void exchange_sides(ViewState *state) {
    MethodNames methods = state->methods[0];
    state->methods[0] = state->methods[1];
    state->methods[1] = methods;
    if (!state->own_sun) return;
    Sun sun = state->scene.values.sun;
    scene_set_sun(&state->scene, state->own_elevation_deg, state->own_azimuth_deg);
    state->own_elevation_deg = sun.elevation_deg;
    state->own_azimuth_deg = sun.azimuth_deg;
}

static void change_range(ViewState *state, bool wider) {
    static const double steps[] = {0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200};
    enum { STEPS = sizeof steps / sizeof *steps };
    int at = 0;
    while (at < STEPS - 1 && steps[at] < state->difference_percent * 0.99) at++;
    at += wider ? 1 : -1;
    state->difference_percent = steps[at < 0 ? 0 : at >= STEPS ? STEPS - 1 : at];
}

static void change_exposure(ViewState *state, double stops) {
    state->scene.values.exposure_ev = fmin(fmax(state->scene.values.exposure_ev + stops, -64), 64);
}

/* Arrows; azimuth grows to the left of who looks along +z. */
static void arrow(ViewState *state, int key, double step_deg, double x, int width) {
    int side = side_at(state, x, width);
    if (key == GLFW_KEY_UP) turn_sun(state, side, step_deg, 0);
    if (key == GLFW_KEY_DOWN) turn_sun(state, side, -step_deg, 0);
    if (key == GLFW_KEY_LEFT) turn_sun(state, side, 0, step_deg);
    if (key == GLFW_KEY_RIGHT) turn_sun(state, side, 0, -step_deg);
}

/* Keys that act at once, and again while they are held. */
static void pressed(ViewState *state, int key, bool shift, int width) {
    if (key >= GLFW_KEY_RIGHT && key <= GLFW_KEY_UP)
        arrow(state, key, shift ? 0.1 : 1, state->pointer[0], width);
    if (key == GLFW_KEY_MINUS) change_exposure(state, -0.25);
    if (key == GLFW_KEY_EQUAL) change_exposure(state, 0.25);
    if (key == GLFW_KEY_COMMA) change_speed(state, 0.5);
    if (key == GLFW_KEY_PERIOD) change_speed(state, 2);
    if (key == GLFW_KEY_LEFT_BRACKET) change_range(state, false);
    if (key == GLFW_KEY_RIGHT_BRACKET) change_range(state, true);
}

/* Keys that act once. */
static void pressed_once(ViewState *state, int key, int width) {
    if (key >= GLFW_KEY_1 && key <= GLFW_KEY_4) view_choose_time(state, key - GLFW_KEY_1);
    switch (key) {
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
        open_prompt(state, side_at(state, state->pointer[0], width));
        break;
    case GLFW_KEY_T:
        toggle_day(state);
        break;
    case GLFW_KEY_R:
        own_camera(state);
        break;
    case GLFW_KEY_C:
        state->wishes.copy = true;
        break;
    case GLFW_KEY_V:
        toggle_split(state);
        break;
    case GLFW_KEY_X:
        exchange_sides(state);
        break;
    case GLFW_KEY_F:
        toggle_difference(state);
        break;
    case GLFW_KEY_B:
        view_own_sun(state, !state->own_sun);
        break;
    case GLFW_KEY_I:
        state->inspect = !state->inspect;
        break;
    case GLFW_KEY_P:
        state->wishes.save = true;
        break;
    case GLFW_KEY_SPACE:
        state->clock_running = !state->clock_running;
        break;
    case GLFW_KEY_Z:
        state->clock_seconds = 0;
        break;
    case GLFW_KEY_H:
        state->overlay = !state->overlay;
        break;
    case GLFW_KEY_ESCAPE:
        state->wishes.quit = true;
        break;
    default:
        break;
    }
}

static void hold(Controls *controls, const ViewState *state, int key, bool down) {
    for (int i = 0; i < 6; i++) {
        if (held_keys[i] == key) controls->held[i] = down;
    }
    if (key != GLFW_KEY_S) return;
    controls->s_drags = false;
    controls->s_since = clock_seconds();
    memcpy(controls->eye_before_s, state->scene.values.camera.eye, sizeof controls->eye_before_s);
    memcpy(controls->target_before_s, state->scene.values.camera.target, sizeof controls->target_before_s);
}

static void on_key(Controls *controls, ViewState *state, const WindowEvent *event, int width) {
    bool control = event->modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER);
    if (event->action == GLFW_RELEASE) {
        hold(controls, state, event->key, false);
    } else if (state->prompting) {
        prompt_key(state, event->key);
    } else if (!control) {
        pressed(state, event->key, event->modifiers & GLFW_MOD_SHIFT, width);
        if (event->action != GLFW_PRESS) return;
        hold(controls, state, event->key, true);
        pressed_once(state, event->key, width);
    } else if (event->action == GLFW_PRESS && event->key == GLFW_KEY_C) {
        state->wishes.copy = true;
    }
}

static Drag drag_of(Controls *controls, ViewState *state, const WindowEvent *event, int width) {
    if (event->key == GLFW_MOUSE_BUTTON_RIGHT) return DRAG_SUN;
    if (event->key == GLFW_MOUSE_BUTTON_MIDDLE) return DRAG_PAN;
    if (event->key != GLFW_MOUSE_BUTTON_LEFT) return DRAG_NONE;
    if (controls->held[HELD_S]) {
        /* The S was no wish to fly. */
        controls->s_drags = true;
        memcpy(state->scene.values.camera.eye, controls->eye_before_s, sizeof state->scene.values.camera.eye);
        memcpy(state->scene.values.camera.target, controls->target_before_s,
               sizeof state->scene.values.camera.target);
        return DRAG_SUN;
    }
    if (state->split && fabs(event->x - state->divider * width) < 8) return DRAG_DIVIDER;
    return event->modifiers & GLFW_MOD_SHIFT ? DRAG_LOOK : DRAG_ORBIT;
}

static void on_button(Controls *controls, ViewState *state, const WindowEvent *event, int width) {
    bool left = event->key == GLFW_MOUSE_BUTTON_LEFT, down = event->action == GLFW_PRESS;
    controls->last[0] = state->pointer[0] = event->x;
    controls->last[1] = state->pointer[1] = event->y;
    if (left) state->left_down = down;
    state->clicked |= left && down;
    if (left && down) {
        memcpy(state->pressed, state->pointer, sizeof state->pressed);
        memcpy(state->dragged, state->pointer, sizeof state->dragged);
    }
    if (down && controls->drag == DRAG_NONE) {
        controls->drag = drag_of(controls, state, event, width);
        controls->drag_button = event->key;
        controls->drag_side = side_at(state, event->x, width);
    } else if (!down && controls->drag_button == event->key) {
        controls->drag = DRAG_NONE;
    }
}

static void drag(Controls *controls, ViewState *state, double right, double up, int width, int height) {
    double fov = state->scene.values.camera.fov_deg, degrees_per_pixel = fmin(fov, 90) / height;
    double metres_per_pixel = 2 * orbit_distance(&state->scene) * tan(fov * degree / 2) / height;
    switch (controls->drag) {
    case DRAG_SUN:
        turn_sun(state, controls->drag_side, up * degrees_per_pixel, -right * degrees_per_pixel);
        break;
    case DRAG_ORBIT:
        orbit_turn(&state->scene, right * 180 / height, up * 180 / height);
        break;
    case DRAG_LOOK:
        orbit_look(&state->scene, -right * degrees_per_pixel, -up * degrees_per_pixel);
        break;
    case DRAG_PAN:
        orbit_move(&state->scene, -right * metres_per_pixel, -up * metres_per_pixel, 0);
        break;
    case DRAG_DIVIDER:
        state->divider = fmin(fmax(state->pointer[0] / width, 0.02), 0.98);
        break;
    case DRAG_NONE:
        break;
    }
}

static void on_move(Controls *controls, ViewState *state, const WindowEvent *event, int width, int height) {
    double right = event->x - controls->last[0], up = controls->last[1] - event->y;
    controls->last[0] = state->pointer[0] = event->x;
    controls->last[1] = state->pointer[1] = event->y;
    if (state->left_down) memcpy(state->dragged, state->pointer, sizeof state->dragged);
    if (right != 0 || up != 0) drag(controls, state, right, up, width, height);
}

void controls_release(Controls *controls) {
    memset(controls->held, 0, sizeof controls->held);
    controls->drag = DRAG_NONE;
}

void controls_event(Controls *controls, ViewState *state, const WindowEvent *event, int width, int height) {
    if (width < 1 || height < 1) return;
    switch (event->kind) {
    case WINDOW_KEY:
        on_key(controls, state, event, width);
        break;
    case WINDOW_TEXT:
        if (state->prompting) prompt_text(state, event->codepoint);
        break;
    case WINDOW_BUTTON:
        on_button(controls, state, event, width);
        break;
    case WINDOW_MOVE:
        on_move(controls, state, event, width, height);
        break;
    case WINDOW_SCROLL:
        orbit_zoom(&state->scene, pow(0.9, event->y));
        break;
    case WINDOW_FOCUS:
        if (!event->action) controls_release(controls);
        break;
    }
}

/* In a second half the way from the eye to its target, at least half a metre. */
void controls_fly(Controls *controls, ViewState *state, double seconds) {
    const bool *held = controls->held;
    bool s_flies = held[HELD_S] && !controls->s_drags && clock_seconds() - controls->s_since > 0.15;
    double step = seconds * fmax(orbit_distance(&state->scene) * 0.5, 0.5);
    double ahead = (held[HELD_W] ? step : 0) - (s_flies ? step : 0);
    double right = (held[HELD_D] ? step : 0) - (held[HELD_A] ? step : 0);
    double up = (held[HELD_E] ? step : 0) - (held[HELD_Q] ? step : 0);
    if (ahead != 0 || right != 0 || up != 0) orbit_move(&state->scene, right, up, ahead);
}
