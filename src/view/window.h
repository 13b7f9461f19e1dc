/* A visible window with an OpenGL 3.3 context. What happens to it is a list of events. */
#pragma once

#include "gl/context.h"

typedef struct GLFWwindow GLFWwindow;

typedef enum WindowEventKind {
    /* Has key, scancode, action and modifiers, in GLFW's numbers. */
    WINDOW_KEY,
    /* Has codepoint. */
    WINDOW_TEXT,
    /* Has key (the button), action, modifiers, x and y. */
    WINDOW_BUTTON,
    /* Has x and y. */
    WINDOW_MOVE,
    /* Has x and y, in steps of the wheel. */
    WINDOW_SCROLL,
    /* Has action: 1 if the window got the keyboard, 0 if it lost it. */
    WINDOW_FOCUS,
    /* A file was dropped on the window: `dropped`. */
    WINDOW_DROP
} WindowEventKind;

typedef struct WindowEvent {
    WindowEventKind kind;
    int key, scancode, action, modifiers;
    unsigned codepoint;
    /* The pointer's place, in pixels of the picture from its top left corner. */
    double x, y;
} WindowEvent;

typedef struct Window {
    GLFWwindow *handle;
    Context context;
    /* The picture's size in pixels. 0 while the window is minimised. */
    int width, height;
    /* Pixels per unit of the window's coordinates. */
    double scale;
    /* The pointer's place at the last event. GLFW's own value may be of a later time. */
    double pointer[2];
    /* The path of the file that was dropped last; owned. */
    char *dropped;
    /* Whether the user wants to close the window. */
    bool closed;
    /* Whether the window's content was lost, or its size has changed. */
    bool exposed;
    WindowEvent *events;
    int event_count, event_capacity;
    /* The first of `events` came after the time `heard`. There were no others until the time `polled`. */
    double heard;
    double polled;
} Window;

/* Opens a window that is at most as large as the screen. Fails with STATUS_NO_GL if there is no display, or
 * no OpenGL 3.3 on it. The Window must not move in memory. */
MUST_CHECK bool window_open(Window *window, const char *title, int width, int height, Error *error);
void window_close(Window *window);

/* Waits up to `seconds` for something to happen. Events are added to `events`, which the caller empties. */
void window_poll(Window *window, double seconds);

/* Says whether something has happened to the window since window_forget_call(), as far as window_poll()
 * knows. Any thread may call it in the middle of long work. */
bool window_calls(void);
void window_forget_call(void);

/* Whether the user has closed the window, or has pressed Escape in an event that nobody has read. */
bool window_wants_end(const Window *window);

/* A window that is never shown. Its context shares textures with this window's. NULL and STATUS_NO_GL if
 * there is none. */
GLFWwindow *window_create_hidden(const Window *window, Error *error);
void window_destroy_hidden(GLFWwindow *hidden);

/* Makes the hidden window's context the calling thread's and fills `context`. */
MUST_CHECK bool window_adopt_hidden(GLFWwindow *hidden, Context *context, Error *error);
void window_release_hidden(void);

/* Shows what was drawn on framebuffer 0. */
void window_present(Window *window);

/* Returns how much larger than usual things should be on this screen, in the window's coordinates. */
double window_magnification(const Window *window);

void window_set_title(Window *window, const char *title);
void window_set_clipboard(Window *window, const char *text);
