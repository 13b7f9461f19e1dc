#include "view/overlay_parts.hpp"

extern "C" {
#include "view/keys.h"
}

#include <cmath>
#include <string>

/* In heights of the font. */
static const float keys_width = 14.5f, what_width = 31;

/* The table's marks of code are not for this place. */
static std::string without_marks(const char *text) {
    std::string plain;
    for (; *text; text++) {
        if (*text != '`') plain += *text;
    }
    return plain;
}

static void keys_table(float width) {
    if (!ImGui::BeginTable("keys", 2)) return;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed,
                            std::fmin(em(keys_width), 0.4f * width));
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    for (int i = 0; keys_help(i); i++) {
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(ImGuiCol_Text, amber);
        ImGui::TextWrapped("%s", keys_help(i)->keys);
        ImGui::PopStyleColor();
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", without_marks(keys_help(i)->what).c_str());
    }
    ImGui::EndTable();
}

/* The height is that of the frame before, as the text is wrapped. */
ImVec4 overlay_help(ViewState *state) {
    ImVec2 display = ImGui::GetIO().DisplaySize;
    float width = std::fmin(em(keys_width + what_width), display.x - em(2 * overlay_margin)),
          highest = std::fmax(display.y - em(2 * overlay_margin), em(3));
    ImGui::SetNextWindowPos(ImVec2(display.x / 2, display.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, highest));
    /* The panel may be behind it. */
    ImGui::SetNextWindowBgAlpha(0.98f);
    if (ImGui::Begin("Keys###help", &state->help,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav))
        keys_table(width);
    ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ImGui::End();
    return ImVec4(corner.x, corner.y, corner.x + size.x, corner.y + size.y);
}
