/* The parts of the overlay: the panel, and notes over the picture. Lengths are in heights of the font. */
#pragma once

extern "C" {
#include "view/figures.h"
}

#include <imgui.h>

#include <vector>

static const float overlay_margin = 0.6f;
static const ImVec4 red(1.0f, 0.45f, 0.4f, 1.0f), grey(0.7f, 0.7f, 0.7f, 1.0f), white(1, 1, 1, 1),
    amber(1.0f, 0.78f, 0.31f, 1.0f);

static inline float em(float heights) {
    return heights * ImGui::GetFontSize();
}

/* Whether a point is in a place, which is from (x, y) to (z, w). */
static inline bool overlay_inside(const ImVec4 &place, const ImVec2 &point) {
    return point.x >= place.x && point.x < place.z && point.y >= place.y && point.y < place.w;
}

/* Draws the panel down to `floor` at the lowest, or a bar of figures if it is closed. `top` is where it began
 * in the frame before. Returns its place, from
 * (x, y) to (z, w). What the user does there changes `state`. */
ImVec4 overlay_panel(ViewState *state, const ViewFigures *figures, float floor, float top);

/* Draws the list of keys in the middle of the picture and returns its place. */
ImVec4 overlay_help(ViewState *state);

/* A note stands on `floor`. Each function returns the floor for the next note. */
float overlay_line(const char *line, float floor);
float overlay_notice(const ViewState *state, float floor);
float overlay_prompt(const ViewState *state, float floor);
float overlay_progress(const ViewState *state, const ViewFigures *figures, float floor);
float overlay_hint(float floor);
float overlay_sides(const ViewState *state, const ViewFigures *figures, float floor);

/* Draws the scale of the false colours in the upper right corner. */
void overlay_range(const ViewState *state);
void overlay_divider(const ViewState *state);

/* Draws the pixel's figures beside the pointer, but not over these places. */
void overlay_pixel(const ViewFigures *figures, const std::vector<ImVec4> &places);
