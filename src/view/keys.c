#include "view/keys.h"

#include "base/number.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const KeysHelp help[] = {
    {"right drag, S + drag", "move the sun"},
    {"arrows, shift + arrows", "the sun by a degree, by a tenth"},
    {"Enter", "type the sun's elevation and azimuth: `-4` or `5 90`"},
    {"1 2 3 4", "the paper's times: sun at 60, 30, 5, -2 degrees"},
    {"T, comma, period", "play a day (the real one with --when and --where), slower, faster"},
    {"left drag, wheel", "orbit, nearer and farther"},
    {"shift + drag, middle drag", "look around, shift the view"},
    {"W A S D, E Q", "fly, up and down"},
    {"R", "the scene's own camera"},
    {"C", "copy camera and sun as annotations"},
    {"L", "copy the command that opens what is shown"},
    {"- =, M", "exposure; automatic exposure"},
    {"V", "two sides with a divider to drag; X exchanges them"},
    {"B", "the right side has a sun of its own, to drag there"},
    {"F, [ ]", "the sides' difference in false colours; their range"},
    {"I", "the pixel under the pointer"},
    {"P", "save what is shown as EXR and PNG"},
    {"Space, Z", "run, reset the scene's iTime"},
    {"drop a file", "open a scene"},
    {"N", "open and close the panel"},
    {"F1, ?", "this list of keys"},
    {"H, Esc", "hide the overlay, quit"},
};

const KeysHelp *keys_help(int index) {
    return index >= 0 && index < (int)(sizeof help / sizeof *help) ? &help[index] : NULL;
}

/* Reads "-4", "-4 90" or "-4, 90". */
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

static void type(ViewState *state, unsigned codepoint) {
    size_t length = strlen(state->prompt);
    bool known = codepoint < 128 && strchr("0123456789+-.,e ", (int)codepoint);
    if (!known || !codepoint || length + 1 >= sizeof state->prompt) return;
    state->prompt[length] = (char)codepoint;
    state->prompt[length + 1] = 0;
}

void keys_text(ViewState *state, unsigned codepoint) {
    if (state->prompting)
        type(state, codepoint);
    else if (codepoint == '?')
        state->help = !state->help;
}

void keys_prompt(ViewState *state, int key) {
    size_t length = strlen(state->prompt);
    if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) end_prompt(state);
    if (key == GLFW_KEY_ESCAPE) state->prompting = false;
    if (key == GLFW_KEY_BACKSPACE && length) state->prompt[length - 1] = 0;
}

static void toggle_day(ViewState *state) {
    state->playing = !state->playing;
    if (state->playing) state->day = day_of(&state->scene.values);
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
    view_set_exposure(state, state->scene.values.exposure_ev + stops);
}

static void toggle_exposure(ViewState *state) {
    state->exposure.on = !state->exposure.on;
    if (state->exposure.on)
        view_notice(state, "automatic exposure");
    else
        view_notice(state, "the exposure stays at %.2f EV", state->scene.values.exposure_ev);
}

/* Handles the arrow keys. Azimuth grows to the left for someone who looks along +z. */
static void arrow(ViewState *state, int key, double step_deg, double x, int width) {
    int side = view_side_at(state, x, width);
    if (key == GLFW_KEY_UP) view_turn_sun(state, side, step_deg, 0);
    if (key == GLFW_KEY_DOWN) view_turn_sun(state, side, -step_deg, 0);
    if (key == GLFW_KEY_LEFT) view_turn_sun(state, side, 0, step_deg);
    if (key == GLFW_KEY_RIGHT) view_turn_sun(state, side, 0, -step_deg);
}

void keys_pressed(ViewState *state, int key, bool shift, int width) {
    if (key >= GLFW_KEY_RIGHT && key <= GLFW_KEY_UP)
        arrow(state, key, shift ? 0.1 : 1, state->pointer[0], width);
    if (key == GLFW_KEY_MINUS) change_exposure(state, -0.25);
    if (key == GLFW_KEY_EQUAL) change_exposure(state, 0.25);
    if (key == GLFW_KEY_COMMA) change_speed(state, 0.5);
    if (key == GLFW_KEY_PERIOD) change_speed(state, 2);
    if (key == GLFW_KEY_LEFT_BRACKET) change_range(state, false);
    if (key == GLFW_KEY_RIGHT_BRACKET) change_range(state, true);
}

void keys_pressed_once(ViewState *state, int key, int width) {
    if (key >= GLFW_KEY_1 && key <= GLFW_KEY_4) view_choose_time(state, key - GLFW_KEY_1);
    switch (key) {
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
        open_prompt(state, view_side_at(state, state->pointer[0], width));
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
    case GLFW_KEY_L:
        state->wishes.link = true;
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
    case GLFW_KEY_M:
        toggle_exposure(state);
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
    case GLFW_KEY_N:
        state->wishes.panel = true;
        break;
    case GLFW_KEY_F1:
        state->help = !state->help;
        break;
    case GLFW_KEY_ESCAPE:
        state->wishes.quit = !state->help;
        state->help = false;
        break;
    default:
        break;
    }
}
