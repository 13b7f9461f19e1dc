#include "view/start.h"

#include <math.h>
#include <stdio.h>

/* The author's exposure is kept if the sun stands where the scene or the preset has it. */
static void start_exposure(ViewState *state, const ViewParams *params) {
    AutoExposure *exposure = &state->exposure;
    SceneValues values = state->scene.values;
    Scene own = {state->scene.file, state->scene.file->values};
    Error error;
    *exposure = (AutoExposure){.on = !params->exposure_set, .target_ev = NAN, .at_once = true};
    if (params->preset && !scene_choose_preset(&own, params->preset, &error)) return;
    values.exposure_ev = own.values.exposure_ev;
    if (values.sun.elevation_deg == own.values.sun.elevation_deg &&
        values.sun.azimuth_deg == own.values.sun.azimuth_deg)
        exposure_anchor(exposure, &values);
}

void start_state(ViewState *state, const ViewParams *params) {
    state->scene = state->file;
    state->methods[0] = state->methods[1] = params->methods;
    snprintf(state->methods[1].light, sizeof state->methods[1].light, "cosine");
    snprintf(state->methods[1].sequence, sizeof state->methods[1].sequence, "random");
    start_exposure(state, params);
    state->divider = 0.5;
    state->difference_percent = 10;
    state->hours_per_second = 1;
    state->clock_seconds = state->file.values.time_s;
    state->overlay = true;
    state->playing = params->record != NULL;
    state->day = day_of(&state->scene.values);
}
