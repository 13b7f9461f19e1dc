#include "view/state.h"

#include "base/clock.h"
#include "base/memory.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void view_notice(ViewState *state, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(state->notice.text, sizeof state->notice.text, format, arguments);
    va_end(arguments);
    state->notice.failed = false;
    state->notice.said = clock_seconds();
}

void view_failure(ViewState *state, const char *text) {
    view_notice(state, "%s", text);
    state->notice.failed = true;
}

bool view_has_notice(const ViewState *state) {
    return state->notice.text[0] && (state->notice.failed || clock_seconds() < state->notice.said + 5);
}

bool view_is_refusal(const Error *error) {
    return error->status == STATUS_USAGE || error->status == STATUS_SCENE;
}

Scene view_scene(const ViewState *state, int side) {
    Scene scene = state->scene;
    if (side == 1 && state->own_sun) scene_set_sun(&scene, state->own_elevation_deg, state->own_azimuth_deg);
    return scene;
}

void view_set_sun(ViewState *state, int side, double elevation_deg, double azimuth_deg) {
    bool own = side == 1 && state->own_sun;
    double elevation = fmin(fmax(elevation_deg, -90), 90);
    double azimuth = azimuth_deg - 360 * floor(azimuth_deg / 360);
    if (own) {
        state->own_elevation_deg = elevation;
        state->own_azimuth_deg = azimuth;
    } else {
        scene_set_sun(&state->scene, elevation, azimuth);
    }
    state->playing = false;
}

void view_turn_sun(ViewState *state, int side, double elevation_deg, double azimuth_deg) {
    Scene scene = view_scene(state, side);
    view_set_sun(state, side, scene.values.sun.elevation_deg + elevation_deg,
                 scene.values.sun.azimuth_deg + azimuth_deg);
}

void view_open(ViewState *state, const char *path) {
    free(state->wishes.open);
    state->wishes.open = memory_string(path);
}

void view_set_exposure(ViewState *state, double exposure_ev) {
    state->scene.values.exposure_ev = fmin(fmax(exposure_ev, -64), 64);
    state->exposure.on = false;
}

int view_side_at(const ViewState *state, double x, int width) {
    return state->split && x > state->divider * width ? 1 : 0;
}

void view_own_sun(ViewState *state, bool own) {
    state->own_sun = own;
    state->own_elevation_deg = state->scene.values.sun.elevation_deg;
    state->own_azimuth_deg = state->scene.values.sun.azimuth_deg;
}

void view_mouse(const ViewState *state, int height, double mouse[4]) {
    if (!state->clicked) {
        memcpy(mouse, state->scene.values.mouse, sizeof state->scene.values.mouse);
        return;
    }
    double sign = state->left_down ? 1 : -1;
    mouse[0] = state->dragged[0];
    mouse[1] = height - state->dragged[1];
    mouse[2] = sign * state->pressed[0];
    mouse[3] = sign * (height - state->pressed[1]);
}

void view_choose_preset(ViewState *state, const char *name) {
    Error error;
    Scene scene = state->scene;
    scene.values.exposure_ev = state->file.values.exposure_ev;
    state->playing = false;
    if (!scene_choose_preset(&scene, name, &error) || !scene_check(&scene, &error)) {
        view_failure(state, error.text);
        return;
    }
    state->scene = scene;
    exposure_anchor(&state->exposure, &scene.values);
    view_notice(state, "preset %s", name);
}

void view_choose_time(ViewState *state, int time) {
    static const struct {
        const char *name;
        double elevation_deg, exposure_ev;
    } times[] = {{"noon", 60, 0}, {"afternoon", 30, 0}, {"sunset", 5, 0.5}, {"early-evening", -2, 4}};
    for (int i = 0; i < state->scene.file->preset_count; i++) {
        if (strcmp(state->scene.file->presets[i].name, times[time].name) == 0) {
            view_choose_preset(state, times[time].name);
            return;
        }
    }
    view_set_sun(state, 0, times[time].elevation_deg, state->scene.values.sun.azimuth_deg);
    state->scene.values.exposure_ev = state->file.values.exposure_ev + times[time].exposure_ev;
    exposure_anchor(&state->exposure, &state->scene.values);
    view_notice(state, "%s", times[time].name);
}

void view_annotations(const ViewState *state, char *out, size_t size) {
    const Viewpoint *camera = &state->scene.values.camera;
    const Sun *sun = &state->scene.values.sun;
    snprintf(out, size,
             "//@ camera  eye %.6g %.6g %.6g  target %.6g %.6g %.6g  fov %.6g\n"
             "//@ sun     elevation %.6g  azimuth %.6g\n",
             camera->eye[0], camera->eye[1], camera->eye[2], camera->target[0], camera->target[1],
             camera->target[2], camera->fov_deg, sun->elevation_deg, sun->azimuth_deg);
}
