#include "view/window.h"

#include "base/clock.h"
#include "base/memory.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* For window_calls(). */
static atomic_bool called;

static Window *window_of(GLFWwindow *handle) {
    return glfwGetWindowUserPointer(handle);
}

static void push(Window *window, WindowEvent event) {
    if (window->event_count == window->event_capacity) {
        window->event_capacity = window->event_capacity ? 2 * window->event_capacity : 64;
        window->events = memory_grow(window->events, (size_t)window->event_capacity, sizeof *window->events);
    }
    window->events[window->event_count++] = event;
}

static void on_key(GLFWwindow *handle, int key, int scancode, int action, int modifiers) {
    push(window_of(handle),
         (WindowEvent){
             .kind = WINDOW_KEY, .key = key, .scancode = scancode, .action = action, .modifiers = modifiers});
}

static void on_text(GLFWwindow *handle, unsigned codepoint) {
    push(window_of(handle), (WindowEvent){.kind = WINDOW_TEXT, .codepoint = codepoint});
}

static void on_button(GLFWwindow *handle, int button, int action, int modifiers) {
    Window *window = window_of(handle);
    push(window, (WindowEvent){.kind = WINDOW_BUTTON,
                               .key = button,
                               .action = action,
                               .modifiers = modifiers,
                               .x = window->pointer[0],
                               .y = window->pointer[1]});
}

static void on_move(GLFWwindow *handle, double x, double y) {
    Window *window = window_of(handle);
    window->pointer[0] = x * window->scale;
    window->pointer[1] = y * window->scale;
    push(window, (WindowEvent){.kind = WINDOW_MOVE, .x = window->pointer[0], .y = window->pointer[1]});
}

static void on_scroll(GLFWwindow *handle, double x, double y) {
    push(window_of(handle), (WindowEvent){.kind = WINDOW_SCROLL, .x = x, .y = y});
}

static void on_focus(GLFWwindow *handle, int focused) {
    push(window_of(handle), (WindowEvent){.kind = WINDOW_FOCUS, .action = focused});
}

/* Of several files the first is taken. */
static void on_drop(GLFWwindow *handle, int count, const char **paths) {
    Window *window = window_of(handle);
    if (count < 1) return;
    free(window->dropped);
    window->dropped = memory_string(paths[0]);
    push(window, (WindowEvent){.kind = WINDOW_DROP});
}

static void on_close(GLFWwindow *handle) {
    window_of(handle)->closed = true;
}

static void on_refresh(GLFWwindow *handle) {
    window_of(handle)->exposed = true;
}

static void measure(Window *window) {
    int width, height, units, units_high, old_width = window->width, old_height = window->height;
    glfwGetFramebufferSize(window->handle, &window->width, &window->height);
    glfwGetWindowSize(window->handle, &units, &units_high);
    width = window->width, height = window->height;
    if (glfwGetWindowAttrib(window->handle, GLFW_ICONIFIED) || width < 1 || height < 1)
        window->width = window->height = 0;
    if (units > 0 && width > 0) window->scale = (double)width / units;
    if (window->width != old_width || window->height != old_height) window->exposed = true;
}

static bool refuse(const char *step, Error *error) {
    const char *reason = NULL;
    glfwGetError(&reason);
    return error_set(error, STATUS_NO_GL, "%s: %s", step, reason ? reason : "no reason given");
}

/* Whether there may be a display. Without the last of these, the Wayland library writes a line of its own to
 * standard error when GLFW tries it. */
static bool may_have_display(void) {
    return getenv("DISPLAY") || getenv("WAYLAND_DISPLAY") || getenv("XDG_RUNTIME_DIR");
}

static void hint_context(void) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
}

/* Creates a window of this size, or as large as the screen allows. */
static GLFWwindow *create(const char *title, int width, int height) {
    int x, y, most_width = 0, most_height = 0;
    GLFWmonitor *monitor = glfwGetPrimaryMonitor();
    if (monitor) glfwGetMonitorWorkarea(monitor, &x, &y, &most_width, &most_height);
    if (most_width > 0 && width > most_width) width = most_width;
    if (most_height > 0 && height > most_height) height = most_height;
    hint_context();
    return glfwCreateWindow(width, height, title, NULL, NULL);
}

bool window_open(Window *window, const char *title, int width, int height, Error *error) {
    *window = (Window){.scale = 1};
    if (!may_have_display()) {
        return error_set(error, STATUS_NO_GL, "no display: neither DISPLAY nor WAYLAND_DISPLAY is set");
    }
    if (!glfwInit()) return refuse("no display", error);
    window->handle = create(title, width, height);
    if (!window->handle) {
        refuse("no window with OpenGL 3.3", error);
        goto fail;
    }
    glfwSetWindowUserPointer(window->handle, window);
    glfwSetKeyCallback(window->handle, on_key);
    glfwSetCharCallback(window->handle, on_text);
    glfwSetMouseButtonCallback(window->handle, on_button);
    glfwSetCursorPosCallback(window->handle, on_move);
    glfwSetScrollCallback(window->handle, on_scroll);
    glfwSetWindowFocusCallback(window->handle, on_focus);
    glfwSetDropCallback(window->handle, on_drop);
    glfwSetWindowCloseCallback(window->handle, on_close);
    glfwSetWindowRefreshCallback(window->handle, on_refresh);
    glfwMakeContextCurrent(window->handle);
    if (!context_adopt(&window->context, glfwGetProcAddress, error)) goto fail;
    /* Drawing sets the pace of frames. Waiting for the screen would take time from it. */
    glfwSwapInterval(0);
    measure(window);
    window->polled = clock_seconds();
    return true;
fail:
    window_close(window);
    return false;
}

void window_close(Window *window) {
    context_close(&window->context);
    if (window->handle) glfwDestroyWindow(window->handle);
    glfwTerminate();
    free(window->events);
    free(window->dropped);
    *window = (Window){0};
}

void window_poll(Window *window, double seconds) {
    double before = clock_seconds();
    int count = window->event_count;
    if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
    /* GLFW has delivered the events that came in the meantime. A wait ends with the first event. */
    /* cppcheck-suppress incorrectLogicOperator */
    if (!count && window->event_count) window->heard = seconds > 0 ? clock_seconds() : window->polled;
    window->polled = before;
    measure(window);
    if (window->event_count || window->exposed || window->closed) atomic_store(&called, true);
}

bool window_calls(void) {
    return atomic_load(&called);
}

void window_forget_call(void) {
    atomic_store(&called, false);
}

bool window_wants_end(const Window *window) {
    bool ends = window->closed;
    for (int i = 0; i < window->event_count; i++) {
        const WindowEvent *event = &window->events[i];
        ends |= event->kind == WINDOW_KEY && event->key == GLFW_KEY_ESCAPE && event->action == GLFW_PRESS;
    }
    return ends;
}

GLFWwindow *window_create_hidden(const Window *window, Error *error) {
    hint_context();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow *hidden = glfwCreateWindow(1, 1, "magichour", NULL, window->handle);
    if (!hidden) refuse("no second OpenGL context", error);
    return hidden;
}

void window_destroy_hidden(GLFWwindow *hidden) {
    glfwDestroyWindow(hidden);
}

bool window_adopt_hidden(GLFWwindow *hidden, Context *context, Error *error) {
    glfwMakeContextCurrent(hidden);
    return context_adopt(context, glfwGetProcAddress, error);
}

void window_release_hidden(void) {
    glfwMakeContextCurrent(NULL);
}

void window_present(Window *window) {
    glfwSwapBuffers(window->handle);
}

double window_magnification(const Window *window) {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window->handle, &x, &y);
    return fmax((double)x / window->scale, 1);
}

void window_set_title(Window *window, const char *title) {
    glfwSetWindowTitle(window->handle, title);
}

void window_set_clipboard(Window *window, const char *text) {
    glfwSetClipboardString(window->handle, text);
}
