#include "view/tasks.h"

#include "base/clock.h"
#include "view/load.h"
#include "view/log.h"
#include "view/record.h"
#include "view/say.h"
#include "view/wishes.h"

#include <stdlib.h>

bool task_reload(void *data, Error *error) {
    View *view = data;
    double start = clock_seconds();
    bool ok = load_again(&view->picture, &view->state, error);
    if (ok) {
        view_notice(&view->state, "%s: read again", view->state.file.file->path);
    } else if (view_is_refusal(error)) {
        say_failure(&view->state, error);
    } else {
        return false;
    }
    load_watch(&view->picture, &view->state, &view->watch);
    watch_folders(&view->watch, !ok);
    view->heard = view->heard > 0 ? view->heard : start;
    log_begin("reload");
    log_text("result", ok ? "good" : "broken");
    log_text("message", ok ? "" : error->text);
    log_number("seconds", clock_seconds() - start);
    log_end();
    return true;
}

bool task_open_other(void *data, Error *error) {
    View *view = data;
    ViewState *state = &view->state;
    char *path = state->wishes.open;
    state->wishes.open = NULL;
    bool ok = load_other(&view->picture, state, path, error);
    if (ok) {
        view_notice(state, "opened %s", path);
        state->wishes.list = view->menu.beside.count || view->menu.installed.count;
        controls_release(&view->controls);
        watch_free(&view->watch);
        load_watch(&view->picture, state, &view->watch);
    } else if (view_is_refusal(error)) {
        say_failure(state, error);
    }
    log_begin("open");
    log_text("path", path);
    log_text("message", ok ? "" : error->text);
    log_end();
    free(path);
    return ok || view_is_refusal(error);
}

bool task_find_figures(void *data, Error *error) {
    View *view = data;
    return picture_figures(&view->picture, &view->state, &view->figures, error);
}

/* Once for each program of a scene. */
static void say_warnings(View *view) {
    const Program *program = &view->picture.panes[0].renderer.program;
    if (!program->id || program->id == view->warned) return;
    view->warned = program->id;
    if (!program->warnings.size) return;
    program_say_warnings(program, stderr);
    view_notice(&view->state, "%s", text_string(&program->warnings));
}

bool task_draw(void *data, Error *error) {
    View *view = data;
    ViewState *state = &view->state;
    Error refusal;
    bool drew = false;
    if (!picture_update(&view->picture, state, &refusal, error)) return false;
    if (refusal.status != STATUS_DONE) say_refusal(state, &refusal);
    if (!picture_draw(&view->picture, state, &drew, error)) return false;
    view->news |= drew;
    say_warnings(view);
    if (!play_say(&view->notes, &view->picture.toy, state, error)) return false;
    /* The last figures are to be shown too. */
    if (drew && picture_rests(&view->picture, state)) view->linger = 2;
    view->busy.worker.context.gl.Finish();
    return true;
}

bool task_save(void *data, Error *error) {
    View *view = data;
    ViewState *state = &view->state;
    if (!view->adapting) wishes_save(state, &view->picture);
    return !view->params->record || !state->playing ||
           record_frame(&view->recorded, &view->picture, state, error);
}

bool task_create_picture(void *data, Error *error) {
    View *view = data;
    return picture_create(&view->picture, view->params, &view->busy.worker.context, &view->state, error);
}

bool task_destroy_picture(void *data, Error *error) {
    View *view = data;
    (void)error;
    picture_destroy(&view->picture);
    return true;
}
