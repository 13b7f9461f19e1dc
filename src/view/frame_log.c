#include "view/frame_log.h"

#include "view/log.h"

static void log_right(const ViewState *state, const SideFigures *side) {
    Scene right = view_scene(state, 1);
    log_number("difference", state->difference ? state->difference_percent : 0);
    log_number("right_elevation", right.values.sun.elevation_deg);
    log_number("right_azimuth", right.values.sun.azimuth_deg);
    log_number("right_prepared", side->prepared);
    log_number("right_samples", (double)side->samples);
    log_number("right_seconds", side->seconds);
    log_number("right_error_percent", side->error_percent);
}

static void log_pixel(const PixelFigures *pixel) {
    log_number("pixel_x", pixel->x);
    log_number("pixel_y", pixel->y);
    log_number("pixel_red", pixel->radiance[0]);
    log_number("pixel_green", pixel->radiance[1]);
    log_number("pixel_blue", pixel->radiance[2]);
    log_number("pixel_samples", pixel->samples);
    log_number("pixel_error_percent", pixel->error_percent);
    log_number("pixel_albedo", pixel->albedo[1]);
    log_number("pixel_depth", pixel->depth);
}

void frame_log(const FrameLog *frame, const ViewState *state, const ViewFigures *figures) {
    const SideFigures *side = &figures->sides[0];
    log_begin("frame");
    log_number("frame", frame->number);
    log_number("frame_ms", 1e3 * figures->frame_s);
    log_number("latency_ms", 1e3 * frame->latency_s);
    log_number("width", frame->width);
    log_number("height", frame->height);
    log_number("elevation", state->scene.values.sun.elevation_deg);
    log_number("azimuth", state->scene.values.sun.azimuth_deg);
    log_number("exposure", state->scene.values.exposure_ev);
    log_number("exposure_automatic", state->exposure.on);
    log_number("eye_x", state->scene.values.camera.eye[0]);
    log_number("eye_y", state->scene.values.camera.eye[1]);
    log_number("eye_z", state->scene.values.camera.eye[2]);
    log_number("panel", state->panel_open);
    log_number("help", state->help);
    log_number("hint", state->hint);
    log_number("sides", state->split ? 2 : 1);
    log_number("picture", frame->pictures);
    log_number("prepared", side->prepared);
    log_number("coarseness", side->coarseness);
    log_number("samples", (double)side->samples);
    log_number("rests", frame->rests);
    log_number("seconds", side->seconds);
    log_number("error_percent", side->error_percent);
    log_number("error_levels", side->error_levels);
    log_number("worst_levels", side->worst_levels);
    log_number("chance_light_percent", side->chance_percent);
    log_number("paths_per_s", side->paths_per_second);
    if (state->split) log_right(state, &figures->sides[1]);
    if (figures->pixel.known) log_pixel(&figures->pixel);
    log_end();
}
