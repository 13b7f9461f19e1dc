#include "view/view.h"

#include "base/clock.h"
#include "view/frame_log.h"
#include "view/load.h"
#include "view/log.h"
#include "view/overlay.h"
#include "view/record.h"
#include "view/say.h"
#include "view/start.h"
#include "view/tasks.h"
#include "view/wishes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The time between two pictures that are shown while the user does nothing. */
static const double rest_interval_s = 0.06;

static bool show(View *view, Error *error) {
    DisplayParams params = picture_display(&view->picture, &view->state);
    if (!display_draw(&view->display, &params, error) || !busy_copy(&view->busy, error)) return false;
    overlay_draw(view->overlay);
    if (!gl_check(&view->window.context.gl, "drawing the overlay", error)) return false;
    window_present(&view->window);
    return true;
}

static void set_title(View *view) {
    const char *title = view->state.file.file->title;
    char text[200];
    snprintf(text, sizeof text, "%s - magichour", *title ? title : view->state.file.file->path);
    window_set_title(&view->window, text);
}

static bool reload_if_changed(View *view, Error *error) {
    if (!watch_changed(&view->watch)) return true;
    if (!busy_run(&view->busy, task_reload, view, error)) return false;
    set_title(view);
    return true;
}

/* Opens the scene that the user wants. While a day is recorded its scene stays. */
static bool open_if_wished(View *view, Error *error) {
    if (!view->state.wishes.open || view->params->record) return true;
    if (!busy_run(&view->busy, task_open_other, view, error)) return false;
    set_title(view);
    return true;
}

static void pass_time(View *view) {
    ViewState *state = &view->state;
    double now = clock_seconds(), passed = fmin(now - view->flown, 0.1);
    view->flown = now;
    controls_fly(&view->controls, state, passed);
    if (state->clock_running) state->clock_seconds += passed;
    if (!state->playing || view->params->record) return;
    record_advance_day(state, passed * state->hours_per_second);
}

static void log_key(int key) {
    log_begin("key");
    log_number("key", key);
    log_end();
}

static void hear(View *view, double wait_s) {
    Window *window = &view->window;
    window_poll(window, wait_s);
    if (window->event_count && !(view->heard > 0)) view->heard = window->heard;
    if (window->event_count || window->exposed) view->linger = 3;
    for (int i = 0; i < window->event_count; i++) {
        const WindowEvent *event = &window->events[i];
        if (event->kind == WINDOW_DROP) view_open(&view->state, window->dropped);
        if (event->kind == WINDOW_KEY && event->action) log_key(event->key);
        if (!overlay_event(view->overlay, event, &view->state))
            controls_event(&view->controls, &view->state, event, window->width, window->height);
    }
    window->event_count = 0;
    window->exposed = false;
}

static bool present(View *view, Error *error) {
    if (!show(view, error)) return false;
    double now = clock_seconds();
    view->figures.frame_s = now - view->shown;
    view->figures.frame_mean_s += 0.2 * (view->figures.frame_s - view->figures.frame_mean_s);
    const FrameLog frame = {.number = view->frames,
                            .pictures = view->picture.pictures,
                            .width = view->window.width,
                            .height = view->window.height,
                            .latency_s = view->heard > 0 ? now - view->heard : 0,
                            .rests = picture_rests(&view->picture, &view->state)};
    frame_log(&frame, &view->state, &view->figures);
    view->shown = now;
    view->heard = 0;
    view->frames++;
    if (view->linger) view->linger--;
    return true;
}

/* Lets the automatic exposure follow the picture. A recorded day has the exposure of each frame's own
 * picture.
 */
static bool adapt(View *view, Error *error) {
    ViewState *state = &view->state;
    double now = clock_seconds(), passed = fmin(now - view->adapted, 0.1);
    view->adapted = now;
    if (!meter_follow(&view->meter, &view->display, &view->picture, state, error)) return false;
    state->exposure.at_once |= view->params->record && state->playing;
    double before = state->scene.values.exposure_ev;
    view->adapting = exposure_adapt(&state->exposure, &state->scene.values.exposure_ev, passed);
    view->news |= state->scene.values.exposure_ev != before;
    return true;
}

/* One turn of the window's loop. */
static bool turn(View *view, Error *error) {
    ViewState *state = &view->state;
    bool busy = !view->frames || view->linger || state->playing || view->adapting ||
                !picture_rests(&view->picture, state);
    hear(view, busy && view->window.width ? 0 : 0.05);
    if (!reload_if_changed(view, error) || !open_if_wished(view, error)) return false;
    menu_update(&view->menu, state, view->params->library);
    pass_time(view);
    wishes_copy(state, view->params, &view->window);
    if (!view->window.width) return true;
    view->picture.width = view->window.width;
    view->picture.height = view->window.height;
    bool due = view->linger || !view->frames || state->playing || state->clock_running || view->adapting ||
               picture_hurries(&view->picture, state) || clock_seconds() > view->shown + rest_interval_s;
    if (due) {
        if (!busy_run(&view->busy, task_find_figures, view, error)) return false;
        overlay_build(view->overlay, state, &view->figures);
    }
    if (!busy_run(&view->busy, task_draw, view, error) || !adapt(view, error)) return false;
    bool saves = (state->wishes.save && !view->adapting) || (view->params->record && state->playing);
    if (saves && !busy_run(&view->busy, task_save, view, error)) return false;
    if (!due || !(view->news || view->linger)) return true;
    view->news = false;
    return present(view, error);
}

static bool open_window(View *view, Error *error) {
    const ViewParams *params = view->params;
    const Scene *scene = &view->state.file;
    int width = params->width ? params->width : scene->file->width,
        height = params->height ? params->height : scene->file->height;
    if (!scene_check_size(width, height, error)) return false;
    if (!window_open(&view->window, "magichour", width, height, error)) {
        error_prefix(error, "view needs a display, `magichour render %s -o FILE.png` none; ", params->path);
        return false;
    }
    set_title(view);
    view->figures.scale = view->window.scale;
    view->figures.menu = &view->menu;
    view->overlay = overlay_create(&view->window, &view->state, error);
    view->busy.params = params;
    view->busy.window = &view->window;
    view->busy.display = &view->display;
    view->busy.overlay = view->overlay;
    return view->overlay && display_create(&view->display, &view->window.context, params->library, error) &&
           meter_create(&view->meter, &view->window.context, error) && busy_start(&view->busy, error) &&
           busy_run(&view->busy, task_create_picture, view, error);
}

static void log_start(const View *view, double started) {
    log_begin("start");
    log_text("scene", view->params->path);
    log_text("gl_renderer", view->window.context.renderer);
    log_number("width", view->window.width);
    log_number("height", view->window.height);
    log_number("startup_seconds", clock_seconds() - started);
    log_end();
}

static void destroy(View *view) {
    /* OpenGL's objects are destroyed with their context, which may be lost. */
    if (view->window.handle) {
        Error ignored;
        if (view->busy.worker.hidden && !busy_run(&view->busy, task_destroy_picture, view, &ignored)) return;
        busy_stop(&view->busy);
        meter_destroy(&view->meter);
        display_destroy(&view->display);
        overlay_destroy(view->overlay);
        window_close(&view->window);
    }
    free(view->state.wishes.open);
    menu_free(&view->menu);
    watch_free(&view->watch);
    scene_destroy(&view->state.file);
}

bool view_run(const ViewParams *params, Error *error) {
    View view = {.params = params};
    double started = clock_seconds();
    if (!load_first(&view.state, params, error)) return false;
    bool ok = open_window(&view, error);
    if (ok) {
        load_watch(&view.picture, &view.state, &view.watch);
        view.flown = view.shown = view.adapted = clock_seconds();
        log_start(&view, started);
    }
    while (ok && !view.window.closed && !view.state.wishes.quit && !(params->stop && params->stop()))
        ok = turn(&view, error);
    log_begin("end");
    log_text("message", ok ? "" : error->text);
    log_number("frames", view.frames);
    log_end();
    destroy(&view);
    return ok;
}
