#include "view/overlay.h"

#include "view/overlay_parts.hpp"

extern "C" {
#include "view/remember.h"
}

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

struct Overlay {
    Window *window;
    /* Keys that were released in the frame in which they were pressed. ImGui would miss these. */
    std::vector<WindowEvent> postponed;
    /* The keys that were pressed in this frame. */
    std::vector<int> pressed;
    bool laid_out;
    /* What takes the mouse: the panel and the list of keys. Their places are from (x, y) to (z, w), in the
     * window's coordinates. */
    std::vector<ImVec4> places;
    ImVec4 panel_place;
    /* The file in which the panel's place is remembered, and what it has; empty if there is none. */
    std::string memory, remembered;
    /* Whether the hint for a first run was seen. Nothing is written before. */
    bool seen;
};

/* Controls are pale, paler under the pointer, and amber where they are set. */
static void choose_colors() {
    static const ImGuiCol touched[][3] = {{ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive},
                                          {ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive},
                                          {ImGuiCol_Header, ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive}};
    ImGui::StyleColorsDark();
    ImVec4 *colors = ImGui::GetStyle().Colors;
    for (const auto &one : touched) {
        for (int i = 0; i < 3; i++) colors[one[i]] = ImVec4(1, 1, 1, 0.11f + 0.08f * (float)i);
    }
    colors[ImGuiCol_WindowBg] = ImVec4(0.07f, 0.07f, 0.08f, 0.9f);
    colors[ImGuiCol_PopupBg] = ImVec4(0.09f, 0.09f, 0.1f, 0.97f);
    colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = colors[ImGuiCol_TitleBgCollapsed] =
        ImVec4(0.14f, 0.14f, 0.16f, 0.95f);
    colors[ImGuiCol_SliderGrab] = ImVec4(0.75f, 0.56f, 0.2f, 1);
    colors[ImGuiCol_SliderGrabActive] = colors[ImGuiCol_CheckMark] = amber;
}

static void choose_sizes(float magnification) {
    ImGuiStyle &style = ImGui::GetStyle();
    style.WindowRounding = style.FrameRounding = style.PopupRounding = 3;
    style.GrabMinSize = 5;
    style.WindowBorderSize = style.PopupBorderSize = 0;
    style.ScaleAllSizes(magnification);
}

/* The font is drawn at its size on the screen, so that it is sharp on dense screens too. */
static void choose_font(float magnification, float scale) {
    ImFontConfig config;
    config.SizePixels = std::floor(13 * magnification * scale);
    ImGui::GetIO().Fonts->AddFontDefault(&config);
    ImGui::GetIO().FontGlobalScale = 1 / scale;
}

/* A first run is one that finds nothing remembered. */
static void recall(Overlay *overlay, ViewState *state) {
    char *path = remember_path();
    if (!path) return;
    overlay->memory = path;
    overlay->seen = remember_exists(path);
    state->hint = !overlay->seen;
    if (overlay->seen) ImGui::LoadIniSettingsFromDisk(path);
    free(path);
}

static void remember(Overlay *overlay) {
    std::string now = ImGui::SaveIniSettingsToMemory(nullptr);
    ImGui::GetIO().WantSaveIniSettings = false;
    if (!overlay->seen || overlay->memory.empty() || now == overlay->remembered) return;
    remember_write(overlay->memory.c_str(), now.c_str());
    overlay->remembered = now;
}

Overlay *overlay_create(Window *window, ViewState *state, Error *error) {
    ImGui::CreateContext();
    /* What is remembered is written here and not by ImGui, which makes no folders. */
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().IniSavingRate = 1;
    float magnification = (float)window_magnification(window);
    choose_colors();
    choose_sizes(magnification);
    choose_font(magnification, (float)window->scale);
    bool windowed = ImGui_ImplGlfw_InitForOpenGL(window->handle, false);
    if (windowed && ImGui_ImplOpenGL3_Init("#version 330 core")) {
        Overlay *overlay = new Overlay{window, {}, {}, false, {}, {}, {}, {}, false};
        recall(overlay, state);
        return overlay;
    }
    if (windowed) ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    error_set(error, STATUS_FAILURE, "the overlay cannot be drawn on this OpenGL");
    return nullptr;
}

void overlay_destroy(Overlay *overlay) {
    if (!overlay) return;
    remember(overlay);
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
    case WINDOW_DROP:
        break;
    }
}

/* Whether a key that was pressed in this frame is released now. */
static bool too_quick(Overlay *overlay, const WindowEvent &event) {
    if (event.kind != WINDOW_KEY) return false;
    if (event.action != 0) overlay->pressed.push_back(event.key);
    if (event.action != 0) return false;
    for (int key : overlay->pressed) {
        if (key == event.key) return true;
    }
    return false;
}

static bool list_is_open() {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

/* Escape closes an open list or colour picker, which loses the focus. It does not close the window then. */
static bool closes_list(const WindowEvent &event) {
    if (event.key != GLFW_KEY_ESCAPE || !list_is_open()) return false;
    ImGui::SetWindowFocus(nullptr);
    return true;
}

/* ImGui's answer is about the pointer of the last frame, and a quick hand has moved it since. */
static bool takes_mouse(const Overlay *overlay, const WindowEvent &event) {
    ImVec2 pointer = ImGui::GetIO().MousePos;
    if (event.kind == WINDOW_BUTTON)
        pointer =
            ImVec2((float)(event.x / overlay->window->scale), (float)(event.y / overlay->window->scale));
    bool inside = false;
    for (const ImVec4 &place : overlay->places) inside |= overlay_inside(place, pointer);
    return inside || (list_is_open() && ImGui::GetIO().WantCaptureMouse);
}

/* A hint is read at leisure, and goes with the first thing that the user does but to move the pointer. */
static void end_hint(Overlay *overlay, ViewState *state, const WindowEvent &event) {
    bool does = event.kind == WINDOW_KEY || event.kind == WINDOW_BUTTON || event.kind == WINDOW_SCROLL;
    if (!state->hint || !does) return;
    state->hint = false;
    overlay->seen = true;
    remember(overlay);
}

bool overlay_event(Overlay *overlay, const WindowEvent *event, ViewState *state) {
    if (!state->overlay) overlay->places.clear();
    end_hint(overlay, state, *event);
    const ImGuiIO &io = ImGui::GetIO();
    if (too_quick(overlay, *event))
        overlay->postponed.push_back(*event);
    else
        tell(overlay, *event);
    bool down = event->action != 0;
    if (event->kind == WINDOW_KEY) return down && (io.WantTextInput || closes_list(*event));
    if (event->kind == WINDOW_TEXT) return io.WantTextInput;
    if (event->kind == WINDOW_BUTTON) return down && takes_mouse(overlay, *event);
    return event->kind == WINDOW_SCROLL && takes_mouse(overlay, *event);
}

/* Places the parts from the bottom up, so that none overlaps another. */
static void lay_out(Overlay *overlay, ViewState *state, const ViewFigures *figures) {
    float floor = ImGui::GetIO().DisplaySize.y - em(overlay_margin);
    bool two = state->split && figures->scene;
    overlay->places.clear();
    if (state->overlay) floor = overlay_notice(state, floor);
    if (state->prompting) floor = overlay_prompt(state, floor);
    floor = overlay_progress(state, figures, floor);
    if (state->overlay && state->hint) floor = overlay_hint(floor);
    if (state->help) overlay->places.push_back(overlay_help(state));
    if (!state->overlay) return;
    if (two) floor = overlay_sides(state, figures, floor);
    if (two && state->difference) overlay_range(state);
    if (two && !state->difference) overlay_divider(state);
    overlay->panel_place = overlay_panel(state, figures, floor, overlay->panel_place.y);
    overlay->places.push_back(overlay->panel_place);
    if (state->inspect) overlay_pixel(figures, overlay->places);
}

void overlay_build(Overlay *overlay, ViewState *state, const ViewFigures *figures) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    lay_out(overlay, state, figures);
    ImGui::Render();
    if (ImGui::GetIO().WantSaveIniSettings) remember(overlay);
    overlay->laid_out = true;
    overlay->pressed.clear();
    for (const WindowEvent &event : overlay->postponed) tell(overlay, event);
    overlay->postponed.clear();
}

void overlay_say(Overlay *overlay, const char *line) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    overlay_line(line, ImGui::GetIO().DisplaySize.y - em(overlay_margin));
    ImGui::Render();
    overlay->laid_out = true;
    overlay_draw(overlay);
}

void overlay_draw(Overlay *overlay) {
    if (overlay->laid_out) ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}
