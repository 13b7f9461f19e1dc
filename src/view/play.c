#include "view/play.h"

#include "base/clock.h"
#include "view/say.h"

#include <math.h>

/* Reading the picture back takes some milliseconds. */
static const double look_interval_s = 2;

ToyMoment play_moment(const Toy *toy, const ViewParams *params, const ViewState *state, int height) {
    ToyMoment moment = {.time_s = state->clock_seconds, .by_clock = true};
    double delta = toy->frame ? moment.time_s - toy->moment.time_s : 0;
    moment.delta_s = fmax(delta, 0);
    if (params->record) {
        double step = view_frame_step(params);
        moment = (ToyMoment){.time_s = state->file.values.time_s + toy->frame * step, .delta_s = step};
    }
    view_mouse(state, height, moment.mouse);
    return moment;
}

bool play_say(PlayNotes *notes, const Toy *toy, ViewState *state, Error *error) {
    double now = clock_seconds(), cut;
    if (!toy->program.id) return true;
    if (notes->program != toy->program.id) {
        *notes = (PlayNotes){.program = toy->program.id};
        toy_say_notes(toy, stderr);
        if (toy->notes.size) view_notice(state, "%s", text_string(&toy->notes));
    }
    if (notes->said_cut || !toy->frame || now < notes->looked + look_interval_s) return true;
    notes->looked = now;
    if (!toy_cut_share(toy, &cut, error)) return false;
    notes->said_cut = cut > 0;
    if (!notes->said_cut) return true;
    Error failure;
    error_set(&failure, STATUS_FAILURE, "%s: %s", state->scene.file->path, TOY_CUT_WORDS);
    say_failure(state, &failure);
    return true;
}
