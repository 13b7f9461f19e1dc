#include "view/overlay_parts.hpp"

#include <cmath>
#include <cstdio>

static const ImGuiWindowFlags note_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                           ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                                           ImGuiWindowFlags_NoSavedSettings;

static ImVec2 note_size(const char *text, float most_width) {
    ImVec2 padding = ImGui::GetStyle().WindowPadding;
    /* One pixel more: a note that just fits may be narrower than its text by rounding. */
    ImVec2 size = ImGui::CalcTextSize(text, nullptr, false, most_width - 2 * padding.x + 1);
    return ImVec2(std::ceil(size.x) + 2 * padding.x, std::ceil(size.y) + 2 * padding.y);
}

/* Draws text that stands on `floor` with its left edge at x, no wider than the window, and returns the floor
 * of the next note. The note does not take the mouse. */
static float note(const char *name, float x, float floor, const ImVec4 &color, const char *text) {
    ImVec2 size = note_size(text, ImGui::GetIO().DisplaySize.x - x - em(overlay_margin));
    ImGui::SetNextWindowPos(ImVec2(x, floor), ImGuiCond_Always, ImVec2(0, 1));
    ImGui::SetNextWindowSize(size);
    if (ImGui::Begin(name, nullptr, note_flags)) {
        ImGui::PushTextWrapPos(size.x - ImGui::GetStyle().WindowPadding.x + 1);
        ImGui::TextColored(color, "%s", text);
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
    return floor - size.y - em(overlay_margin);
}

/* The note has a fixed width, because ImGui would adapt it one frame late. */
void overlay_pixel(const ViewFigures *figures, const std::vector<ImVec4> &places) {
    char text[320];
    ImVec2 pointer = ImGui::GetIO().MousePos;
    for (const ImVec4 &place : places) {
        if (overlay_inside(place, pointer)) return;
    }
    if (!figures->pixel.known) return;
    figures_pixel(&figures->pixel, text, sizeof text);
    ImGui::BeginTooltip();
    ImGui::Dummy(ImVec2(em(20), 0));
    ImGui::TextUnformatted(text);
    ImGui::EndTooltip();
}

/* Each note is on its side of the divider if there is room. In a window without room only the panel shows the
 * figures. */
float overlay_sides(const ViewState *state, const ViewFigures *figures, float floor) {
    char texts[MOST_SIDES][400];
    for (int i = 0; i < MOST_SIDES; i++) {
        Scene scene = view_scene(state, i);
        int sun = state->own_sun ? snprintf(texts[i], sizeof texts[i], "sun %.4g %.4g\n",
                                            scene.values.sun.elevation_deg, scene.values.sun.azimuth_deg)
                                 : 0;
        figures_side(&figures->sides[i], texts[i] + sun, sizeof texts[i] - (size_t)sun);
    }
    float gap = em(overlay_margin), end = ImGui::GetIO().DisplaySize.x - gap,
          x = (float)state->divider * (end + gap);
    float left = note_size(texts[0], end).x, right = note_size(texts[1], end).x;
    if (gap + left + gap + right > end) return floor;
    float left_x = std::fmin(std::fmax(x - gap - left, gap), end - right - gap - left);
    float right_x = std::fmin(std::fmax(x + gap, left_x + left + gap), end - right);
    return std::fmin(note("left", left_x, floor, white, texts[0]),
                     note("right", right_x, floor, white, texts[1]));
}

static void range_bar(float width) {
    ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList *list = ImGui::GetWindowDrawList();
    ImVec2 middle(corner.x + width / 2, corner.y + em(1));
    const ImU32 blue = IM_COL32(59, 76, 192, 255), pale = IM_COL32(221, 221, 221, 255),
                warm = IM_COL32(180, 4, 38, 255);
    list->AddRectFilledMultiColor(corner, middle, blue, pale, pale, blue);
    list->AddRectFilledMultiColor(ImVec2(middle.x, corner.y), ImVec2(corner.x + width, middle.y), pale, warm,
                                  warm, pale);
    ImGui::Dummy(ImVec2(width, em(1.1f)));
}

void overlay_range(const ViewState *state) {
    char ends[2][48];
    ImVec2 display = ImGui::GetIO().DisplaySize;
    float padding = ImGui::GetStyle().WindowPadding.x,
          width = std::fmin(em(22), display.x - em(2 * overlay_margin) - 2 * padding);
    snprintf(ends[0], sizeof ends[0], "right +%g %%", state->difference_percent);
    snprintf(ends[1], sizeof ends[1], "left +%g %%", state->difference_percent);
    ImGui::SetNextWindowPos(ImVec2(display.x - em(overlay_margin), em(overlay_margin)), ImGuiCond_Always,
                            ImVec2(1, 0));
    if (ImGui::Begin("range", nullptr, note_flags | ImGuiWindowFlags_AlwaysAutoResize)) {
        range_bar(width);
        ImGui::TextUnformatted(ends[0]);
        ImGui::SameLine(padding + (width - ImGui::CalcTextSize("of the mean").x) / 2);
        ImGui::TextColored(grey, "of the mean");
        ImGui::SameLine(padding + width - ImGui::CalcTextSize(ends[1]).x);
        ImGui::TextUnformatted(ends[1]);
    }
    ImGui::End();
}

void overlay_divider(const ViewState *state) {
    ImVec2 size = ImGui::GetIO().DisplaySize;
    float x = (float)state->divider * size.x;
    ImGui::GetBackgroundDrawList()->AddLine(ImVec2(x, 0), ImVec2(x, size.y), IM_COL32(255, 255, 255, 160), 1);
}

float overlay_prompt(const ViewState *state, float floor) {
    char text[160];
    const char *side = state->own_sun ? state->prompt_side ? "right " : "left " : "";
    snprintf(text, sizeof text, "%ssun's elevation [azimuth], degrees: %s_", side, state->prompt);
    float width = ImGui::GetIO().DisplaySize.x, free = width - note_size(text, width).x;
    return note("prompt", std::fmax(free / 2, em(overlay_margin)), floor, white, text);
}

float overlay_hint(float floor) {
    const char *text = "Drag with the right mouse button to move the sun, with the left one to look around.\n"
                       "Press Enter and type an elevation to set the sun: -4 is a night.\n"
                       "F1 or ? lists the keys, and N opens and closes the panel.";
    float width = ImGui::GetIO().DisplaySize.x, free = width - note_size(text, width).x;
    return note("hint", std::fmax(free / 2, em(overlay_margin)), floor, white, text);
}

float overlay_progress(const ViewState *state, const ViewFigures *figures, float floor) {
    char text[64];
    const SideFigures *left = &figures->sides[0], *right = &figures->sides[1];
    const SideFigures *side = state->split && right->prepared < left->prepared ? right : left;
    /* A note that comes and goes at each halt of the hand would only disturb. */
    if (side->prepared == 1 || side->waited_s < 0.3) return floor;
    figures_progress(side, text, sizeof text);
    return note("progress", em(overlay_margin), floor, amber, text);
}

float overlay_line(const char *line, float floor) {
    return note("line", em(overlay_margin), floor, amber, line);
}

float overlay_notice(const ViewState *state, float floor) {
    if (!view_has_notice(state)) return floor;
    return note("notice", em(overlay_margin), floor, state->notice.failed ? red : white, state->notice.text);
}
