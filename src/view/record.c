#include "view/record.h"

#include "view/log.h"

#include <stdio.h>

void record_advance_day(ViewState *state, double hours) {
    day_advance(&state->day, hours);
    day_apply(&state->day, &state->scene.values);
}

/* Whether that was the last frame: of those that were asked for, of the day, or of some seconds. */
static bool is_last(int done, const Picture *picture, const ViewState *state) {
    const ViewParams *params = picture->params;
    double seconds = done * view_frame_step(params);
    if (params->frames) return done >= params->frames;
    return state->scene.file->facts.is_toy ? seconds > RECORD_SECONDS - 1e-6
                                           : seconds * state->hours_per_second >= day_length(&state->day);
}

bool record_frame(int *done, const Picture *picture, ViewState *state, Error *error) {
    const ViewParams *params = picture->params;
    char name[4096];
    if (!picture_has_frame(picture, state, *done)) return true;
    snprintf(name, sizeof name, "%s/frame-%05d", params->record, ++*done);
    if (!picture_save(picture, state, name, false, error)) return false;
    log_begin("recorded");
    log_text("name", name);
    log_end();
    record_advance_day(state, view_frame_step(params) * state->hours_per_second);
    if (is_last(*done, picture, state)) state->wishes.quit = true;
    return true;
}
