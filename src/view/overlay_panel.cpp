#include "view/overlay_parts.hpp"

extern "C" {
#include "choice/method.h"
#include "scene/sun_clock.h"
}

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

/* In heights of the font, as all lengths here. */
static const float panel_width = 19;

static void tooltip(const char *text) {
    if (*text && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

/* A slider for a double. */
static bool slider(const char *label, double *value, double min, double max, const char *format) {
    float number = (float)*value;
    if (!ImGui::SliderFloat(label, &number, (float)min, (float)max, format)) return false;
    *value = number < (float)min ? min : number > (float)max ? max : number;
    return true;
}

/* When and where, if that is what says where the sun stands. */
static void clock_line(const SunClock *clock) {
    if (!sun_clock_runs(clock)) return;
    Text text = {nullptr, 0, 0};
    sun_clock_print(clock, &text);
    ImGui::TextWrapped("%s", text_string(&text));
    text_free(&text);
}

static void sun_section(ViewState *state) {
    clock_line(&state->scene.values.clock);
    double elevation = state->scene.values.sun.elevation_deg, azimuth = state->scene.values.sun.azimuth_deg;
    bool moved = slider("elevation", &elevation, -18, 90, "%.2f deg");
    moved = slider("azimuth", &azimuth, 0, 360, "%.2f deg") || moved;
    if (moved) view_set_sun(state, 0, elevation, azimuth);
    static const char *const times[] = {"60", "30", "5", "-2"}, *const names[] = {"noon", "afternoon",
                                                                                  "sunset", "early evening"};
    for (int i = 0; i < 4; i++) {
        if (i) ImGui::SameLine();
        if (ImGui::Button(times[i], ImVec2(em(2.2f), 0))) view_choose_time(state, i);
        tooltip(names[i]);
    }
    ImGui::SameLine();
    if (ImGui::Button(state->playing ? "stop the day" : "play a day")) {
        state->playing = !state->playing;
        state->day = day_of(&state->scene.values);
    }
    if (state->playing) slider("hours/s", &state->hours_per_second, 0.01, 4, "%.2f");
    double exposure = state->scene.values.exposure_ev;
    if (slider("exposure", &exposure, -8, 16, state->exposure.on ? "%.2f EV, automatic" : "%.2f EV"))
        view_set_exposure(state, exposure);
    ImGui::Checkbox("automatic exposure", &state->exposure.on);
}

static void preset_section(ViewState *state) {
    for (int i = 0; i < state->scene.file->preset_count; i++) {
        const char *name = state->scene.file->presets[i].name;
        float next = ImGui::CalcTextSize(name).x + em(1.2f);
        float used = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
        if (i && used + next < em(panel_width)) ImGui::SameLine();
        if (ImGui::Button(name)) view_choose_preset(state, name);
    }
}

static void parameter(const Parameter *p, double *value) {
    float color[3] = {(float)value[0], (float)value[1], (float)value[2]};
    bool on = value[0] > 0;
    std::string unit(p->unit);
    /* A percent sign of the unit would be taken as a format. */
    std::replace(unit.begin(), unit.end(), '%', ' ');
    std::string format = "%.3g " + unit;
    switch (p->type) {
    case PARAMETER_SLIDER:
        slider(p->name, value, p->min, p->max, format.c_str());
        break;
    case PARAMETER_CHECKBOX:
        if (ImGui::Checkbox(p->name, &on)) value[0] = on;
        break;
    case PARAMETER_COLOR:
        if (!ImGui::ColorEdit3(p->name, color)) break;
        for (int c = 0; c < 3; c++) value[c] = std::fmin(std::fmax(color[c], 0.0f), 1.0f);
        break;
    }
    tooltip(p->label);
}

/* The names of a family's methods, and those of their variants that differ in speed. */
static std::vector<const char *> method_choices(MethodFamily family) {
    std::vector<const char *> choices{"auto"};
    for (int i = 0; method_get(i); i++) {
        const Method *method = method_get(i);
        if (method->family != family) continue;
        if (!method->variants[0]) choices.push_back(method->name);
        for (const char *variant : method->variants) {
            if (variant) choices.push_back(variant);
        }
    }
    return choices;
}

/* An empty `name` is auto. */
static void method_combo(const char *label, MethodFamily family, char *name, size_t size) {
    if (!ImGui::BeginCombo(label, *name ? name : "auto")) return;
    for (const char *choice : method_choices(family)) {
        bool automatic = method_is_auto(choice);
        if (ImGui::Selectable(choice, strcmp(choice, *name ? name : "auto") == 0))
            snprintf(name, size, "%s", automatic ? "" : choice);
    }
    ImGui::EndCombo();
}

static void method_combos(MethodNames *methods) {
    method_combo("sky", METHOD_SKY, methods->sky, sizeof methods->sky);
    method_combo("further orders", METHOD_FURTHER, methods->further, sizeof methods->further);
    method_combo("light", METHOD_LIGHT, methods->light, sizeof methods->light);
    method_combo("sequence", METHOD_SEQUENCE, methods->sequence, sizeof methods->sequence);
    method_combo("sun's disk", METHOD_SUN, methods->sun_disk, sizeof methods->sun_disk);
}

static void curve_plot(const ErrorCurve *curve) {
    ImVec2 corner = ImGui::GetCursorScreenPos(), size(em(panel_width), em(4.4f));
    float pad = em(0.25f);
    ImDrawList *list = ImGui::GetWindowDrawList();
    ImGui::Dummy(size);
    list->AddRectFilled(corner, ImVec2(corner.x + size.x, corner.y + size.y), IM_COL32(0, 0, 0, 90), 3);
    if (curve->count < 2) return;
    std::vector<ImVec2> points;
    for (int i = 0; i < curve->count; i++) {
        double place[2];
        curve_place(curve, i, place);
        points.push_back(ImVec2(corner.x + pad + (size.x - 2 * pad) * (float)place[0],
                                corner.y + pad + (size.y - 2 * pad) * (float)place[1]));
    }
    list->AddPolyline(points.data(), (int)points.size(), ImGui::GetColorU32(amber), 0, em(0.12f));
    /* The curve falls, so there is room above its end and below its start. */
    char from[48], to[48];
    snprintf(from, sizeof from, "from %.3g %%", curve->percent[0]);
    snprintf(to, sizeof to, "to %.3g %% in %.1f s", curve->percent[curve->count - 1],
             curve->seconds[curve->count - 1]);
    ImU32 color = ImGui::GetColorU32(grey);
    list->AddText(ImVec2(corner.x + size.x - ImGui::CalcTextSize(from).x - 2 * pad, corner.y + pad), color,
                  from);
    list->AddText(ImVec2(corner.x + 2 * pad, corner.y + size.y - ImGui::GetFontSize() - pad), color, to);
}

static void side_section(const SideFigures *side) {
    char text[64], speed[32];
    figures_error(side, text, sizeof text);
    ImGui::TextColored(std::isfinite(side->error_percent) ? white : grey, "%s", text);
    snprintf(speed, sizeof speed, "%.1f Mpaths/s", 1e-6 * side->paths_per_second);
    ImGui::SameLine(em(panel_width) + ImGui::GetStyle().WindowPadding.x - ImGui::CalcTextSize(speed).x);
    ImGui::TextUnformatted(speed);
    figures_levels(side, text, sizeof text);
    ImGui::TextUnformatted(text);
    figures_progress(side, text, sizeof text);
    ImGui::TextUnformatted(text);
    ImGui::PushTextWrapPos(em(panel_width));
    if (side->chance_percent > 0)
        ImGui::Text("%.2g %% of the light is found by chance", side->chance_percent);
    if (*side->wrong) ImGui::TextColored(amber, "%s", side->wrong);
    ImGui::TextColored(grey, "%s", side->methods);
    ImGui::PopTextWrapPos();
    curve_plot(&side->curve);
}

static void split_section(ViewState *state, const ViewFigures *figures) {
    if (ImGui::Checkbox("two sides", &state->split) && !state->split) state->difference = false;
    ImGui::SameLine();
    if (ImGui::Checkbox("their difference", &state->difference) && state->difference) state->split = true;
    if (!state->split) return;
    ImGui::PushID("right");
    ImGui::TextColored(grey, "right side");
    method_combos(&state->methods[1]);
    bool own = state->own_sun;
    if (ImGui::Checkbox("a sun of its own", &own)) view_own_sun(state, own);
    if (state->own_sun) {
        slider("elevation", &state->own_elevation_deg, -18, 90, "%.2f deg");
        slider("azimuth", &state->own_azimuth_deg, 0, 360, "%.2f deg");
    }
    side_section(&figures->sides[1]);
    ImGui::PopID();
}

static void scene_list(ViewState *state, const char *heading, const SceneList *list) {
    if (!list->count) return;
    ImGui::TextColored(grey, "%s", heading);
    for (int i = 0; i < list->count; i++) {
        const SceneEntry *entry = &list->entries[i];
        const char *slash = strrchr(entry->path, '/'), *open = strrchr(state->file.file->path, '/');
        bool is_open = strcmp(slash + 1, open ? open + 1 : state->file.file->path) == 0;
        ImGui::PushID(entry->path);
        if (ImGui::Selectable(entry->name, is_open)) view_open(state, entry->path);
        tooltip(entry->path);
        if (*entry->title) {
            ImGui::SameLine(em(9));
            ImGui::TextColored(grey, "%s", entry->title);
        }
        ImGui::PopID();
    }
}

/* The lists are read when this part is unfolded. */
static void open_section(ViewState *state, const SceneMenu *menu) {
    bool unfolded = ImGui::CollapsingHeader("open a scene");
    if (unfolded && ImGui::IsItemToggledOpen()) state->wishes.list = true;
    if (!unfolded) return;
    scene_list(state, "beside this one", &menu->beside);
    scene_list(state, "installed", &menu->installed);
    ImGui::TextColored(grey, "or drop a file on the window");
}

static void scene_panel(ViewState *state, const ViewFigures *figures) {
    sun_section(state);
    if (state->scene.file->preset_count && ImGui::CollapsingHeader("presets", ImGuiTreeNodeFlags_DefaultOpen))
        preset_section(state);
    if (state->scene.file->parameter_count &&
        ImGui::CollapsingHeader("scene", ImGuiTreeNodeFlags_DefaultOpen)) {
        for (int i = 0; i < state->scene.file->parameter_count; i++)
            parameter(&state->scene.file->parameters[i], state->scene.values.parameters[i]);
    }
    if (ImGui::CollapsingHeader("methods")) method_combos(&state->methods[0]);
    if (ImGui::CollapsingHeader("two sides")) split_section(state, figures);
}

static const char *panel_title(const ViewState *state) {
    const char *slash = strrchr(state->file.file->path, '/');
    return state->file.file->title[0] ? state->file.file->title : slash ? slash + 1 : state->file.file->path;
}

static void panel_content(ViewState *state, const ViewFigures *figures) {
    ImGui::PushItemWidth(em(11));
    if (figures->scene) {
        side_section(&figures->sides[0]);
        scene_panel(state, figures);
    } else {
        ImGui::Text("frame %llu, %.2f s", (unsigned long long)figures->sides[0].samples,
                    state->clock_seconds);
    }
    open_section(state, figures->menu);
    if (ImGui::Button("keys")) state->help = true;
    ImGui::SameLine();
    ImGui::TextColored(grey, "%dx%d, %.0f ms a frame", figures->width, figures->height,
                       1e3 * figures->frame_s);
    ImGui::PushTextWrapPos(em(panel_width));
    ImGui::TextColored(grey, "%s", figures->gl_renderer);
    ImGui::PopTextWrapPos();
    ImGui::PopItemWidth();
}

/* The title of an open panel, and the figures that stand in its place when it is closed. */
static std::string title(const ViewState *state, const ViewFigures *figures, float widest) {
    char bar[200];
    if (state->panel_open) return panel_title(state);
    int most = (int)((widest - em(3)) / ImGui::CalcTextSize("0").x);
    figures_bar(figures, &state->scene.values.sun, most, bar, sizeof bar);
    return bar;
}

/* The panel is closed at first if it would hide a quarter of the picture. */
ImVec4 overlay_panel(ViewState *state, const ViewFigures *figures, float floor, float top) {
    ImVec2 display = ImGui::GetIO().DisplaySize;
    float widest = display.x - em(2 * overlay_margin),
          highest = std::fmax(floor - std::fmax(top, em(overlay_margin)), em(8));
    std::string text = title(state, figures, widest), name = text + "###panel";
    float bar = std::fmin(ImGui::CalcTextSize(text.c_str()).x + em(3), widest),
          width = state->panel_open ? std::fmin(em(panel_width), widest) : bar;
    ImGui::SetNextWindowPos(ImVec2(em(overlay_margin), em(overlay_margin)), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowCollapsed(display.x < 4 * em(panel_width) || display.y < em(18),
                                  ImGuiCond_FirstUseEver);
    if (state->wishes.panel) ImGui::SetNextWindowCollapsed(state->panel_open);
    state->wishes.panel = false;
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0),
                                        ImVec2(state->panel_open ? widest : width, highest));
    state->panel_open = ImGui::Begin(name.c_str(), nullptr, ImGuiWindowFlags_AlwaysAutoResize);
    if (state->panel_open) panel_content(state, figures);
    ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ImGui::End();
    return ImVec4(corner.x, corner.y, corner.x + size.x, corner.y + size.y);
}
