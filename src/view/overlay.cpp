#include "view/overlay.h"

extern "C" {
#include "render/method.h"
#include "view/controls.h"
}

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

struct Overlay {
    Window *window;
    std::vector<WindowEvent>
        postponed; /* keys let go of in the frame in which they were pressed: ImGui would miss those */
    std::vector<int> pressed; /* in this frame */
    bool laid_out;
    bool panel;         /* is shown, ... */
    ImVec4 panel_place; /* ... from x, y to z, w in the window's coordinates */
};

static const float panel_width = 19; /* in heights of the font */
static const ImVec4 red(1.0f, 0.45f, 0.4f, 1.0f), grey(0.7f, 0.7f, 0.7f, 1.0f), white(1, 1, 1, 1);

Overlay *overlay_create(Window *window, Error *error) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::StyleColorsDark();
    ImGui::GetStyle().WindowRounding = 4;
    ImGui::GetStyle().Colors[ImGuiCol_WindowBg].w = 0.8f;
    float magnification = (float)window_magnification(window);
    ImGui::GetIO().FontGlobalScale = magnification;
    ImGui::GetStyle().ScaleAllSizes(magnification);
    bool windowed = ImGui_ImplGlfw_InitForOpenGL(window->handle, false);
    if (windowed && ImGui_ImplOpenGL3_Init("#version 330 core"))
        return new Overlay{window, {}, {}, false, false, {}};
    if (windowed) ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    error_set(error, STATUS_FAILURE, "the overlay cannot be drawn on this OpenGL");
    return nullptr;
}

void overlay_destroy(Overlay *overlay) {
    if (!overlay) return;
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    delete overlay;
}

static void tell(const Overlay *overlay, const WindowEvent &event) {
    GLFWwindow *handle = overlay->window->handle;
    switch (event.kind) {
    case WINDOW_KEY:
        ImGui_ImplGlfw_KeyCallback(handle, event.key, event.scancode, event.action, event.modifiers);
        break;
    case WINDOW_TEXT:
        ImGui_ImplGlfw_CharCallback(handle, event.codepoint);
        break;
    case WINDOW_BUTTON:
        ImGui_ImplGlfw_MouseButtonCallback(handle, event.key, event.action, event.modifiers);
        break;
    case WINDOW_SCROLL:
        ImGui_ImplGlfw_ScrollCallback(handle, event.x, event.y);
        break;
    case WINDOW_MOVE:
#if IMGUI_VERSION_NUM >= 18700
        ImGui_ImplGlfw_CursorPosCallback(handle, event.x / overlay->window->scale,
                                         event.y / overlay->window->scale);
#endif
        break;
    case WINDOW_FOCUS:
        ImGui_ImplGlfw_WindowFocusCallback(handle, event.action);
        break;
    }
}

/* Whether a key was pressed in this frame and is let go of now. */
static bool too_quick(Overlay *overlay, const WindowEvent &event) {
    if (event.kind != WINDOW_KEY) return false;
    if (event.action != 0) overlay->pressed.push_back(event.key);
    if (event.action != 0) return false;
    for (int key : overlay->pressed) {
        if (key == event.key) return true;
    }
    return false;
}

/* ImGui tells what is under the pointer of the last frame, which a quick hand has left by now. */
static bool takes_mouse(const Overlay *overlay, const WindowEvent &event) {
    if (!overlay->panel) return false;
    const ImVec4 &place = overlay->panel_place;
    ImVec2 pointer = ImGui::GetIO().MousePos;
    if (event.kind == WINDOW_BUTTON)
        pointer =
            ImVec2((float)(event.x / overlay->window->scale), (float)(event.y / overlay->window->scale));
    bool inside = pointer.x >= place.x && pointer.x < place.z && pointer.y >= place.y && pointer.y < place.w;
    bool list = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    return inside || (list && ImGui::GetIO().WantCaptureMouse);
}

bool overlay_event(Overlay *overlay, const WindowEvent *event, bool panel) {
    overlay->panel &= panel;
    const ImGuiIO &io = ImGui::GetIO();
    if (too_quick(overlay, *event))
        overlay->postponed.push_back(*event);
    else
        tell(overlay, *event);
    bool down = event->action != 0;
    if (event->kind == WINDOW_KEY) return io.WantTextInput && down;
    if (event->kind == WINDOW_TEXT) return io.WantTextInput;
    if (event->kind == WINDOW_BUTTON) return down && takes_mouse(overlay, *event);
    return event->kind == WINDOW_SCROLL && takes_mouse(overlay, *event);
}

static void tooltip(const char *text) {
    if (*text && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

/* A slider on a double. */
static bool slider(const char *label, double *value, double min, double max, const char *format) {
    float number = (float)*value;
    if (!ImGui::SliderFloat(label, &number, (float)min, (float)max, format)) return false;
    *value = number < (float)min ? min : number > (float)max ? max : number;
    return true;
}

static void sun_section(ViewState *state) {
    double elevation = state->scene.sun_elevation_deg, azimuth = state->scene.sun_azimuth_deg;
    bool moved = slider("elevation", &elevation, -18, 90, "%.2f deg");
    moved = slider("azimuth", &azimuth, 0, 360, "%.2f deg") || moved;
    if (moved) view_set_sun(state, 0, elevation, azimuth);
    static const char *const times[] = {"60", "30", "5", "-2"};
    for (int i = 0; i < 4; i++) {
        if (i) ImGui::SameLine();
        if (ImGui::SmallButton(times[i])) view_choose_time(state, i);
    }
    ImGui::SameLine();
    if (ImGui::SmallButton(state->playing ? "stop the day" : "play a day")) {
        state->playing = !state->playing;
        state->day = day_through(elevation, azimuth);
    }
    if (state->playing) slider("hours/s", &state->hours_per_second, 0.01, 4, "%.2f");
    slider("exposure", &state->scene.exposure_ev, -8, 8, "%.2f EV");
}

static void preset_section(ViewState *state) {
    for (int i = 0; i < state->scene.preset_count; i++) {
        const char *name = state->scene.presets[i].name;
        float next = ImGui::CalcTextSize(name).x + 16, unit = ImGui::GetFontSize();
        float used = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
        if (i && used + next < panel_width * unit) ImGui::SameLine();
        if (ImGui::SmallButton(name)) view_choose_preset(state, name);
    }
}

static void parameter(Parameter *p) {
    float color[3] = {(float)p->value[0], (float)p->value[1], (float)p->value[2]};
    bool on = p->value[0] > 0;
    char format[32];
    snprintf(format, sizeof format, "%%.3g %s", p->unit);
    for (char *c = format + 5; *c; c++) {
        if (*c == '%') *c = ' '; /* a unit is no format */
    }
    switch (p->type) {
    case PARAMETER_SLIDER:
        slider(p->name, &p->value[0], p->min, p->max, format);
        break;
    case PARAMETER_CHECKBOX:
        if (ImGui::Checkbox(p->name, &on)) p->value[0] = on;
        break;
    case PARAMETER_COLOR:
        if (!ImGui::ColorEdit3(p->name, color)) break;
        for (int c = 0; c < 3; c++) p->value[c] = std::fmin(std::fmax(color[c], 0.0f), 1.0f);
        break;
    }
    tooltip(p->label);
}

/* The methods of a family by name, with those variants of a sky that differ in speed. */
static std::vector<const char *> method_choices(MethodFamily family) {
    static const char *const skies[] = {"table",      "gauss:4",     "gauss:8", "gauss:12",
                                        "paper:16x4", "paper:64x16", "uniform"};
    std::vector<const char *> choices{"auto"};
    if (family == METHOD_SKY) {
        choices.insert(choices.end(), skies, skies + sizeof skies / sizeof *skies);
        return choices;
    }
    for (int i = 0; method_get(i); i++) {
        if (method_get(i)->family == family) choices.push_back(method_get(i)->name);
    }
    return choices;
}

/* `name` is empty for auto. */
static void method_combo(const char *label, MethodFamily family, char *name, size_t size) {
    if (!ImGui::BeginCombo(label, *name ? name : "auto")) return;
    for (const char *choice : method_choices(family)) {
        bool automatic = strcmp(choice, "auto") == 0;
        if (ImGui::Selectable(choice, strcmp(choice, *name ? name : "auto") == 0))
            snprintf(name, size, "%s", automatic ? "" : choice);
    }
    ImGui::EndCombo();
}

static void method_combos(MethodNames *methods) {
    method_combo("sky", METHOD_SKY, methods->sky, sizeof methods->sky);
    method_combo("light", METHOD_LIGHT, methods->light, sizeof methods->light);
    method_combo("sequence", METHOD_SEQUENCE, methods->sequence, sizeof methods->sequence);
    method_combo("sun's disk", METHOD_SUN, methods->sun_disk, sizeof methods->sun_disk);
}

/* Error over time, both logarithmic: a straight line that falls by half where the time quadruples. */
static void curve_plot(const ErrorCurve *curve) {
    ImVec2 corner = ImGui::GetCursorScreenPos(), size(panel_width * ImGui::GetFontSize(), 56);
    ImDrawList *list = ImGui::GetWindowDrawList();
    ImGui::Dummy(size);
    list->AddRectFilled(corner, ImVec2(corner.x + size.x, corner.y + size.y), IM_COL32(0, 0, 0, 90));
    if (curve->count < 2) return;
    double first = std::log(curve->seconds[0]), last = std::log(curve->seconds[curve->count - 1]), low = 1e9,
           high = -1e9;
    for (int i = 0; i < curve->count; i++) {
        low = std::fmin(low, std::log(curve->percent[i]));
        high = std::fmax(high, std::log(curve->percent[i]));
    }
    double width = std::fmax(last - first, 1e-3), height = std::fmax(high - low, 1e-3);
    std::vector<ImVec2> points;
    for (int i = 0; i < curve->count; i++) {
        points.push_back(
            ImVec2(corner.x + size.x * (float)((std::log(curve->seconds[i]) - first) / width),
                   corner.y + 3 + (size.y - 6) * (float)((high - std::log(curve->percent[i])) / height)));
    }
    list->AddPolyline(points.data(), (int)points.size(), IM_COL32(255, 200, 80, 255), 0, 1.5f);
    char text[64];
    snprintf(text, sizeof text, "%.3g %%", std::exp(high));
    list->AddText(ImVec2(corner.x + size.x - 56, corner.y + 2), IM_COL32(200, 200, 200, 255), text);
    snprintf(text, sizeof text, "%.3g s", std::exp(last));
    list->AddText(ImVec2(corner.x + size.x - 56, corner.y + size.y - 16), IM_COL32(200, 200, 200, 255), text);
}

static void side_figures(const SideFigures *side, bool curve) {
    if (side->coarseness > 1)
        ImGui::Text("preview, 1/%d", side->coarseness);
    else
        ImGui::Text("%llu samples in %.1f s", (unsigned long long)side->samples, side->seconds);
    ImGui::Text("%.1f Mpaths/s", 1e-6 * side->paths_per_second);
    ImGui::SameLine();
    if (std::isfinite(side->error_percent))
        ImGui::Text("error about %.2f %%", side->error_percent);
    else
        ImGui::TextColored(grey, "error not yet known");
    ImGui::PushTextWrapPos(panel_width * ImGui::GetFontSize());
    ImGui::TextColored(grey, "%s", side->methods);
    ImGui::PopTextWrapPos();
    if (curve) curve_plot(&side->curve);
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
    side_figures(&figures->sides[1], true);
    ImGui::PopID();
}

static void help_section(void) {
    if (!ImGui::CollapsingHeader("keys")) return;
    for (int i = 0; controls_help(i); i++) {
        ImGui::TextColored(grey, "%s", controls_help(i)->keys);
        ImGui::SameLine(ImGui::GetFontSize() * 13);
        ImGui::TextUnformatted(controls_help(i)->what);
    }
}

static void scene_panel(ViewState *state, const ViewFigures *figures) {
    sun_section(state);
    if (state->scene.preset_count && ImGui::CollapsingHeader("presets", ImGuiTreeNodeFlags_DefaultOpen))
        preset_section(state);
    if (state->scene.parameter_count && ImGui::CollapsingHeader("scene", ImGuiTreeNodeFlags_DefaultOpen)) {
        for (int i = 0; i < state->scene.parameter_count; i++) parameter(&state->scene.parameters[i]);
    }
    if (ImGui::CollapsingHeader("methods")) method_combos(&state->methods[0]);
    if (ImGui::CollapsingHeader("two sides")) split_section(state, figures);
}

static void panel(Overlay *overlay, ViewState *state, const ViewFigures *figures) {
    float unit = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(8, 8), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints(ImVec2(unit * panel_width, 0),
                                        ImVec2(unit * 50, ImGui::GetIO().DisplaySize.y - 16));
    const char *title = state->scene.title[0] ? state->scene.title : "scene";
    char name[160];
    snprintf(name, sizeof name, "%s###panel", title);
    if (ImGui::Begin(name, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::PushItemWidth(unit * 11);
        if (figures->scene) {
            side_figures(&figures->sides[0], true);
            scene_panel(state, figures);
        } else {
            ImGui::Text("frame %llu, %.2f s", (unsigned long long)figures->sides[0].samples,
                        state->clock_seconds);
        }
        ImGui::TextColored(grey, "%dx%d, %.0f ms a frame", figures->width, figures->height,
                           1e3 * figures->frame_s);
        ImGui::TextColored(grey, "%s", figures->gl_renderer);
        help_section();
        ImGui::PopItemWidth();
    }
    ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    overlay->panel_place = ImVec4(corner.x, corner.y, corner.x + size.x, corner.y + size.y);
    ImGui::End();
}

static const ImGuiWindowFlags note_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                           ImGuiWindowFlags_NoNav | ImGuiWindowFlags_AlwaysAutoResize |
                                           ImGuiWindowFlags_NoFocusOnAppearing;

/* Text at a place, wrapped to a width; the mouse does not see it. */
static void note(const char *name, ImVec2 place, ImVec2 pivot, float width, const ImVec4 &color,
                 const char *text) {
    ImGui::SetNextWindowPos(place, ImGuiCond_Always, pivot);
    if (ImGui::Begin(name, nullptr, note_flags)) {
        ImGui::PushTextWrapPos(width - 16);
        ImGui::TextColored(color, "%s", text);
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
}

static void pixel_note(const ViewState *state, const ViewFigures *figures) {
    const PixelFigures *p = &figures->pixel;
    char text[320], depth[32] = "none";
    if (!p->known) return;
    if (p->hits > 0) snprintf(depth, sizeof depth, "%.4g m", p->depth);
    snprintf(text, sizeof text,
             "pixel %d %d\nradiance %.4g %.4g %.4g\nerror %.2g %% of it, %.0f samples\nalbedo %.3f %.3f "
             "%.3f, depth %s",
             p->x, p->y, p->radiance[0], p->radiance[1], p->radiance[2], p->error_percent, p->samples,
             p->albedo[0], p->albedo[1], p->albedo[2], depth);
    float x = (float)(state->pointer[0] / figures->scale), y = (float)(state->pointer[1] / figures->scale);
    ImVec2 size = ImGui::GetIO().DisplaySize;
    ImVec2 pivot(x > size.x * 0.6f ? 1.0f : 0.0f, y > size.y * 0.7f ? 1.0f : 0.0f);
    note("pixel", ImVec2(x + (pivot.x > 0 ? -14.0f : 14.0f), y + (pivot.y > 0 ? -14.0f : 14.0f)), pivot,
         size.x, white, text);
}

static void side_note(const ViewState *state, const SideFigures *side, int number, float x) {
    char text[400], error[48] = "", sun[64] = "";
    ImVec2 size = ImGui::GetIO().DisplaySize;
    Scene scene = view_scene(state, number);
    if (state->own_sun)
        snprintf(sun, sizeof sun, "sun %.4g %.4g\n", scene.sun_elevation_deg, scene.sun_azimuth_deg);
    if (std::isfinite(side->error_percent))
        snprintf(error, sizeof error, "\nerror about %.2f %%", side->error_percent);
    snprintf(text, sizeof text, "%s%s\n%llu samples in %.1f s\n%.1f Mpaths/s%s", sun, side->methods,
             (unsigned long long)side->samples, side->seconds, 1e-6 * side->paths_per_second, error);
    bool left = number == 0;
    note(left ? "left" : "right", ImVec2(left ? x - 8 : x + 8, size.y - 8), ImVec2(left ? 1.0f : 0.0f, 1),
         left ? x - 8 : size.x - x - 8, white, text);
}

/* What the false colours mean. */
static void range_bar(const ViewState *state) {
    ImVec2 corner = ImGui::GetCursorScreenPos();
    float width = 25 * ImGui::GetFontSize();
    ImDrawList *list = ImGui::GetWindowDrawList();
    ImVec2 middle(corner.x + width / 2, corner.y + 12);
    const ImU32 blue = IM_COL32(59, 76, 192, 255), pale = IM_COL32(221, 221, 221, 255),
                warm = IM_COL32(180, 4, 38, 255);
    list->AddRectFilledMultiColor(corner, middle, blue, pale, pale, blue);
    list->AddRectFilledMultiColor(ImVec2(middle.x, corner.y), ImVec2(corner.x + width, middle.y), pale, warm,
                                  warm, pale);
    ImGui::Dummy(ImVec2(width, 13));
    ImGui::Text("right brighter by %g %% of the mean, left by %g %%", state->difference_percent,
                state->difference_percent);
}

static void range_note(const ViewState *state) {
    ImGui::SetNextWindowPos(ImVec2(ImGui::GetIO().DisplaySize.x - 8, 8), ImGuiCond_Always, ImVec2(1, 0));
    if (ImGui::Begin("range", nullptr, note_flags)) range_bar(state);
    ImGui::End();
}

static void divider_line(const ViewState *state) {
    ImVec2 size = ImGui::GetIO().DisplaySize;
    float x = (float)state->divider * size.x;
    ImGui::GetBackgroundDrawList()->AddLine(ImVec2(x, 0), ImVec2(x, size.y), IM_COL32(255, 255, 255, 160), 1);
}

static void side_notes(const ViewState *state, const ViewFigures *figures) {
    float x = (float)state->divider * ImGui::GetIO().DisplaySize.x;
    for (int i = 0; i < MOST_SIDES; i++) side_note(state, &figures->sides[i], i, x);
}

static void notice(const ViewState *state) {
    ImVec2 size = ImGui::GetIO().DisplaySize;
    char prompt[128];
    if (state->prompting) {
        snprintf(prompt, sizeof prompt, "sun's elevation [azimuth], degrees: %s_", state->prompt);
        note("prompt", ImVec2(size.x / 2, size.y - 40), ImVec2(0.5f, 1), size.x, white, prompt);
    }
    if (view_has_notice(state))
        note("notice", ImVec2(8, size.y - 8), ImVec2(0, 1), size.x - 16, state->notice.failed ? red : white,
             state->notice.text);
}

void overlay_build(Overlay *overlay, ViewState *state, const ViewFigures *figures) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    if (state->split && !state->difference) divider_line(state);
    if (state->overlay) {
        panel(overlay, state, figures);
        if (state->split) side_notes(state, figures);
        if (state->difference) range_note(state);
    }
    if (state->overlay || state->prompting) notice(state);
    if (state->inspect) pixel_note(state, figures);
    ImGui::Render();
    overlay->laid_out = true;
    overlay->panel = state->overlay;
    overlay->pressed.clear();
    for (const WindowEvent &event : overlay->postponed) tell(overlay, event);
    overlay->postponed.clear();
}

void overlay_draw(Overlay *overlay) {
    if (overlay->laid_out) ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}
