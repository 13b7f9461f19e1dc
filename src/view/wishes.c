#include "view/wishes.h"

#include "view/log.h"
#include "view/say.h"

static void copy(ViewState *state, Window *window, const char *text) {
    window_set_clipboard(window, text);
    view_notice(state, "copied:\n%s", text);
    log_begin("copy");
    log_text("text", text);
    log_end();
}

void wishes_copy(ViewState *state, Window *window) {
    char text[512];
    if (!state->wishes.copy) return;
    state->wishes.copy = false;
    view_annotations(state, text, sizeof text);
    copy(state, window, text);
}

void wishes_save(ViewState *state, const Picture *picture) {
    char name[300];
    Error error;
    if (!state->wishes.save || !picture_is_whole(picture, state)) return;
    state->wishes.save = false;
    save_choose_name(&state->scene, name, sizeof name);
    bool ok = picture_save(picture, state, name, true, &error);
    if (ok)
        view_notice(state, "saved %s.exr and .png", name);
    else
        say_failure(state, &error);
    log_begin("save");
    log_text("name", name);
    log_text("message", ok ? "" : error.text);
    log_number("samples", (double)picture->panes[0].renderer.film.samples);
    log_end();
}
