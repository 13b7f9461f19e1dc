#include "view/controls.h"

#include "base/clock.h"
#include "base/vec3.h"
#include "view/keys.h"
#include "view/orbit.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <math.h>
#include <string.h>

enum { HELD_W, HELD_A, HELD_S, HELD_D, HELD_E, HELD_Q };
static const int held_keys[] = {GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D, GLFW_KEY_E, GLFW_KEY_Q};

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
        keys_prompt(state, event->key);
    } else if (!control) {
        keys_pressed(state, event->key, event->modifiers & GLFW_MOD_SHIFT, width);
        if (event->action != GLFW_PRESS) return;
        hold(controls, state, event->key, true);
        keys_pressed_once(state, event->key, width);
    } else if (event->action == GLFW_PRESS && event->key == GLFW_KEY_C) {
        state->wishes.copy = true;
    }
}

static Drag drag_of(Controls *controls, ViewState *state, const WindowEvent *event, int width) {
    if (event->key == GLFW_MOUSE_BUTTON_RIGHT) return DRAG_SUN;
    if (event->key == GLFW_MOUSE_BUTTON_MIDDLE) return DRAG_PAN;
    if (event->key != GLFW_MOUSE_BUTTON_LEFT) return DRAG_NONE;
    if (controls->held[HELD_S]) {
        /* The S did not mean to fly. */
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
        controls->drag_side = view_side_at(state, event->x, width);
    } else if (!down && controls->drag_button == event->key) {
        controls->drag = DRAG_NONE;
    }
}

static void drag(Controls *controls, ViewState *state, double right, double up, int width, int height) {
    double fov = state->scene.values.camera.fov_deg, degrees_per_pixel = fmin(fov, 90) / height;
    double metres_per_pixel = 2 * orbit_distance(&state->scene) * tan(fov * degree / 2) / height;
    switch (controls->drag) {
    case DRAG_SUN:
        view_turn_sun(state, controls->drag_side, up * degrees_per_pixel, -right * degrees_per_pixel);
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
        keys_text(state, event->codepoint);
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
    case WINDOW_DROP:
        break;
    }
}

/* The speed is half the way from the eye to its target in a second, but at least half a metre. */
void controls_fly(Controls *controls, ViewState *state, double seconds) {
    const bool *held = controls->held;
    bool s_flies = held[HELD_S] && !controls->s_drags && clock_seconds() - controls->s_since > 0.15;
    double step = seconds * fmax(orbit_distance(&state->scene) * 0.5, 0.5);
    double ahead = (held[HELD_W] ? step : 0) - (s_flies ? step : 0);
    double right = (held[HELD_D] ? step : 0) - (held[HELD_A] ? step : 0);
    double up = (held[HELD_E] ? step : 0) - (held[HELD_Q] ? step : 0);
    if (ahead != 0 || right != 0 || up != 0) orbit_move(&state->scene, right, up, ahead);
}
