#include "view/wishes.h"

#include "view/command.h"
#include "view/log.h"
#include "view/say.h"

static void copy(ViewState *state, Window *window, const char *text) {
    window_set_clipboard(window, text);
    view_notice(state, "copied:\n%s", text);
    log_begin("copy");
    log_text("text", text);
    log_end();
}

static void copy_link(ViewState *state, const ViewParams *params, Window *window) {
    Text text = {0};
    const LinkParams link = {.scene = &state->scene,
                             .methods = &state->methods[0],
                             .width = window->width,
                             .height = window->height,
                             .seed = params->seed,
                             .max_hits = params->max_hits,
                             .glsl_dir = params->glsl_dir};
    view_link(&link, &text);
    copy(state, window, text_string(&text));
    text_free(&text);
}

void wishes_copy(ViewState *state, const ViewParams *params, Window *window) {
    char text[512];
    view_annotations(state, text, sizeof text);
    if (state->wishes.copy) copy(state, window, text);
    if (state->wishes.link) copy_link(state, params, window);
    state->wishes.copy = state->wishes.link = false;
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
