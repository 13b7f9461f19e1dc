#include "view/load.h"

#include "view/carry.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int side_count(const ViewState *state) {
    return state->split ? 2 : 1;
}

/* The author's exposure is kept if the sun stands where the scene or the preset has it. */
static void anchor_exposure(ViewState *state, const char *preset) {
    AutoExposure *exposure = &state->exposure;
    SceneValues values = state->scene.values;
    Scene own = {state->scene.file, state->scene.file->values};
    Error error;
    *exposure = (AutoExposure){.on = exposure->on, .target_ev = NAN, .at_once = true};
    if (preset && !scene_choose_preset(&own, preset, &error)) return;
    values.exposure_ev = own.values.exposure_ev;
    if (values.sun.elevation_deg == own.values.sun.elevation_deg &&
        values.sun.azimuth_deg == own.values.sun.azimuth_deg)
        exposure_anchor(exposure, &values);
}

/* Begins with the scene of `state->file`. */
static void begin_scene(ViewState *state, const char *preset) {
    state->scene = state->file;
    anchor_exposure(state, preset);
    state->own_sun = state->playing = state->prompting = state->clicked = false;
    state->clock_running = state->file.file->facts.is_toy;
    state->clock_seconds = state->file.values.time_s;
    state->day = day_of(&state->scene.values);
}

bool load_first(ViewState *state, const ViewParams *params, Error *error) {
    if (!params->load(params->data, &state->file, error)) return false;
    state->methods[0] = state->methods[1] = params->methods;
    snprintf(state->methods[1].light, sizeof state->methods[1].light, "cosine");
    snprintf(state->methods[1].sequence, sizeof state->methods[1].sequence, "random");
    state->exposure.on = !params->exposure_set;
    begin_scene(state, params->preset);
    state->divider = 0.5;
    state->difference_percent = 10;
    state->hours_per_second = 1;
    state->overlay = true;
    state->playing = params->record != NULL;
    return true;
}

/* Reloads all sides, or none if one of them fails. */
static bool reload_sides(Picture *picture, const ViewState *state, Error *error) {
    Renderer next[MOST_SIDES] = {{0}};
    Scene scenes[MOST_SIDES];
    PaneParams params[MOST_SIDES];
    bool ok = true;
    for (int i = 0; ok && i < side_count(state); i++) {
        scenes[i] = view_scene(state, i);
        params[i] = picture_pane_params(picture, state, i, &scenes[i]);
        ok = pane_compile(&params[i], &next[i], error);
    }
    for (int i = 0; i < side_count(state); i++) {
        if (ok)
            pane_take(&picture->panes[i], &params[i], &next[i]);
        else
            renderer_destroy(&next[i]);
    }
    return ok;
}

static bool reload_content(Picture *picture, ViewState *state, Error *error) {
    const SceneFile *file = state->scene.file;
    if (file->facts.is_toy) {
        if (!toy_compile(&picture->toy, picture->context, file, error)) return false;
        for (int i = 0; i < MOST_SIDES; i++) pane_destroy(&picture->panes[i]);
        return true;
    }
    if (!reload_sides(picture, state, error)) return false;
    toy_destroy(&picture->toy);
    return true;
}

static void take_file(Picture *picture, ViewState *state, const Scene *file) {
    scene_destroy(&state->file);
    state->file = *file;
    picture->pictures++;
    inspect_destroy(&picture->inspect);
}

/* The command line's settings are those of its own scene. */
static bool read_again(const Picture *picture, const ViewState *state, Scene *scene, Error *error) {
    const ViewParams *params = picture->params;
    if (!state->opened) return params->load(params->data, scene, error);
    return scene_read(scene, state->file.file->path, params->library, error);
}

bool load_again(Picture *picture, ViewState *state, Error *error) {
    Scene before = state->scene, file;
    bool is_anchor = exposure_is_anchor(&state->exposure, &before.values);
    if (!read_again(picture, state, &file, error)) return false;
    state->scene = file;
    carry_over(&state->scene, &state->file, &before);
    if (!reload_content(picture, state, error)) {
        state->scene = before;
        scene_destroy(&file);
        return false;
    }
    exposure_reload(&state->exposure, &state->file.values, &file.values, &state->scene.values, is_anchor);
    take_file(picture, state, &file);
    picture->good_scene = state->scene;
    return true;
}

bool load_other(Picture *picture, ViewState *state, const char *path, Error *error) {
    Scene before = state->scene, file;
    bool own_sun = state->own_sun;
    if (!scene_read(&file, path, picture->params->library, error)) return false;
    state->scene = file;
    state->own_sun = false;
    if (!scene_check(&file, error) || !reload_content(picture, state, error)) {
        state->scene = before;
        state->own_sun = own_sun;
        scene_destroy(&file);
        return false;
    }
    take_file(picture, state, &file);
    state->opened = true;
    begin_scene(state, NULL);
    toy_restart(&picture->toy);
    for (int i = 0; i < MOST_SIDES; i++) pane_hurry(&picture->panes[i]);
    picture->good_scene = state->scene;
    return true;
}

void load_watch(Picture *picture, const ViewState *state, Watch *watch) {
    const SceneFile *file = state->scene.file;
    watch_add_file(watch, file->path);
    watch_add(watch, file->sources);
    picture->wants_time = !file->facts.is_toy && scene_facts_mention(&file->facts, INPUT_TIME);
    picture->wants_mouse = !file->facts.is_toy && scene_facts_mention(&file->facts, INPUT_MOUSE);
}
