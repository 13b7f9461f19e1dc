#include "view/picture.h"

#include "base/clock.h"
#include "view/play.h"
#include "view/window.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* How long the picture counts as moving after a change; drawing time of a frame in motion and at rest. */
static const double moving_s = 0.15;
static const double moving_budget_s = 0.02;
static const double rest_budget_s = 0.03;
static const uint64_t many_samples = 1 << 20;

static bool is_toy(const Picture *picture) {
    return picture->toy.program.id != 0;
}

static int side_count(const ViewState *state) {
    return state->split ? 2 : 1;
}

static bool moves(const Picture *picture) {
    return clock_seconds() < picture->changed + moving_s;
}

bool picture_hurries(const Picture *picture, const ViewState *state) {
    bool ready = true;
    for (int i = 0; i < side_count(state) && !is_toy(picture); i++)
        ready &= pane_is_ready(&picture->panes[i]);
    return !ready || moves(picture);
}

PaneParams picture_pane_params(const Picture *picture, const ViewState *state, int side, const Scene *scene) {
    const ViewParams *params = picture->params;
    bool moving = moves(picture);
    return (PaneParams){.context = picture->context,
                        .scene = scene,
                        .methods = &state->methods[side],
                        .width = picture->width,
                        .height = picture->height,
                        .seed = params->seed,
                        .max_hits = params->max_hits,
                        .samples = params->samples ? params->samples : many_samples,
                        .moving = moving,
                        .whole = params->record && state->playing,
                        .stop = window_calls,
                        .budget_s = (moving ? moving_budget_s : rest_budget_s) / side_count(state)};
}

bool picture_create(Picture *picture, const ViewParams *params, const Context *context, ViewState *state,
                    Error *error) {
    *picture = (Picture){.params = params, .context = context};
    return !state->file.file->facts.is_toy || toy_compile(&picture->toy, context, state->file.file, error);
}

void picture_destroy(Picture *picture) {
    inspect_destroy(&picture->inspect);
    for (int i = 0; i < MOST_SIDES; i++) pane_destroy(&picture->panes[i]);
    toy_destroy(&picture->toy);
}

static bool update_side(Picture *picture, ViewState *state, int side, Error *refusal, Error *error) {
    Scene scene = view_scene(state, side);
    PaneParams params = picture_pane_params(picture, state, side, &scene);
    Pane *pane = &picture->panes[side];
    if (pane_update(pane, &params, error)) {
        if (pane->changed) picture->changed = clock_seconds();
        picture->pictures += pane->changed;
        return true;
    }
    if (!view_is_refusal(error) || !picture->panes[0].renderer.gl) return false;
    *refusal = *error;
    if (!pane->renderer.gl) state->split = state->difference = false;
    state->scene = picture->good_scene;
    memcpy(state->methods, picture->good_methods, sizeof state->methods);
    return true;
}

bool picture_update(Picture *picture, ViewState *state, Error *refusal, Error *error) {
    refusal->status = STATUS_DONE;
    if (is_toy(picture))
        return toy_resize(&picture->toy, picture->context, picture->width, picture->height, error);
    if (picture->wants_time) state->scene.values.time_s = state->clock_seconds;
    if (picture->wants_mouse) view_mouse(state, picture->height, state->scene.values.mouse);
    for (int i = 0; i < side_count(state); i++) {
        if (!update_side(picture, state, i, refusal, error)) return false;
    }
    if (!state->split && picture->panes[1].renderer.gl) pane_destroy(&picture->panes[1]);
    picture->good_scene = state->scene;
    memcpy(picture->good_methods, state->methods, sizeof picture->good_methods);
    return true;
}

static bool draw_toy(Picture *picture, const ViewState *state, bool *drew, Error *error) {
    Toy *toy = &picture->toy;
    ToyMoment moment = play_moment(toy, picture->params, state, picture->height);
    if (picture_rests(picture, state)) return true;
    *drew = true;
    return toy_draw(toy, &state->scene, &moment, rest_budget_s, window_calls, error);
}

/* Two sides at rest get the same time, so that a side which was opened or changed later catches up. */
static bool is_ahead(const Picture *picture, const ViewState *state, int side) {
    const Pane *pane = &picture->panes[side], *other = &picture->panes[1 - side];
    PaneParams params = picture_pane_params(picture, state, 1 - side, NULL);
    if (!state->split || pane->preview_samples || other->preview_samples) return false;
    return pane->seconds > other->seconds && !pane_rests(other, &params);
}

bool picture_draw(Picture *picture, const ViewState *state, bool *drew, Error *error) {
    if (is_toy(picture)) return draw_toy(picture, state, drew, error);
    for (int i = 0; i < side_count(state); i++) {
        Scene scene = view_scene(state, i);
        PaneParams params = picture_pane_params(picture, state, i, &scene);
        Pane *pane = &picture->panes[i];
        *drew |= !pane_rests(pane, &params);
        if (is_ahead(picture, state, i)) continue;
        if (!pane_draw(pane, &params, error)) return false;
    }
    return true;
}

bool picture_rests(const Picture *picture, const ViewState *state) {
    const Toy *toy = &picture->toy;
    if (is_toy(picture)) return !state->clock_running && toy->frame > 0 && toy->row == 0;
    for (int i = 0; i < side_count(state); i++) {
        PaneParams params = picture_pane_params(picture, state, i, NULL);
        if (!pane_rests(&picture->panes[i], &params)) return false;
    }
    return true;
}

bool picture_has_frame(const Picture *picture, const ViewState *state, int done) {
    const Toy *toy = &picture->toy;
    return is_toy(picture) ? toy->row == 0 && toy->frame > done : picture_rests(picture, state);
}

static DisplaySide display_side(const Pane *pane) {
    const Film *film = &pane->renderer.film;
    bool has_picture = film->samples > 0 || !pane->kept.target.gl;
    if (has_picture) return (DisplaySide){film, NULL, 0};
    /* Its rows lack the light that is traced from the sun. */
    return (DisplaySide){&pane->kept, film, film->light ? 0 : pane->renderer.row};
}

/* The radiance at the ends of the false colours; 0 if they are not shown. */
static double difference_shown(const Picture *picture, const ViewState *state) {
    double mean = picture->panes[0].estimate.mean;
    return state->difference ? state->difference_percent / 100 * (mean > 0 ? mean : 1) : 0;
}

DisplayParams picture_display(const Picture *picture, const ViewState *state) {
    DisplayParams params = {.width = picture->width,
                            .height = picture->height,
                            .divider = state->divider,
                            .exposure_ev = state->scene.values.exposure_ev};
    if (is_toy(picture)) {
        params.raw = toy_texture(&picture->toy);
        return params;
    }
    for (int i = 0; i < side_count(state); i++) params.sides[i] = display_side(&picture->panes[i]);
    params.difference = difference_shown(picture, state);
    return params;
}

/* The pixel is not known either while the scene's file is broken. */
static bool fill_pixel(Picture *picture, const ViewState *state, PixelFigures *pixel, Error *error) {
    int side = state->split && state->pointer[0] > state->divider * picture->width ? 1 : 0;
    const Pane *pane = &picture->panes[side];
    pixel->known = false;
    if (!state->inspect || !state->overlay || pane->preview_samples || !pane_is_ready(pane)) return true;
    RenderParams params = {.scene = &state->scene};
    bool ok = inspect_pixel(&picture->inspect, picture->context, &params, &pane->renderer,
                            (int)floor(state->pointer[0]), (int)floor(state->pointer[1]), pixel, error);
    pixel->place = state->split ? 1 + side : 0;
    return ok || view_is_refusal(error);
}

bool picture_figures(Picture *picture, const ViewState *state, ViewFigures *figures, Error *error) {
    figures->width = picture->width;
    figures->height = picture->height;
    figures->gl_renderer = picture->context->renderer;
    figures->scene = !is_toy(picture);
    if (is_toy(picture)) {
        figures->sides[0] = (SideFigures){.samples = (uint64_t)picture->toy.frame,
                                          .error_percent = NAN,
                                          .error_levels = NAN,
                                          .coarseness = 1,
                                          .prepared = 1};
        return true;
    }
    for (int i = 0; i < MOST_SIDES; i++) pane_figures(&picture->panes[i], &figures->sides[i]);
    return fill_pixel(picture, state, &figures->pixel, error);
}

bool picture_is_whole(const Picture *picture, const ViewState *state) {
    if (is_toy(picture)) return picture->toy.frame > 0;
    for (int i = 0; i < side_count(state); i++) {
        const Pane *pane = &picture->panes[i];
        if (!pane_is_ready(pane) || pane->preview_samples || !pane->renderer.film.samples) return false;
    }
    return true;
}

bool picture_save(const Picture *picture, const ViewState *state, const char *name, bool exr, Error *error) {
    SaveParams params = {.sides = {&picture->panes[0], state->split ? &picture->panes[1] : NULL},
                         .divider = state->divider,
                         .difference = difference_shown(picture, state),
                         .scene = &state->scene,
                         .context = picture->context,
                         .max_hits = picture->params->max_hits,
                         .glsl_dir = picture->params->glsl_dir};
    if (is_toy(picture)) return save_texture(&picture->toy.target, state->file.file->path, name, exr, error);
    return save_picture(&params, name, exr, error);
}
