/* A visible window with an OpenGL 3.3 context, and what happens to it as a list of events. */
#pragma once

#include "gl/context.h"

typedef struct GLFWwindow GLFWwindow;

typedef enum WindowEventKind {
    WINDOW_KEY,    /* key, scancode, action, modifiers: GLFW's own numbers */
    WINDOW_TEXT,   /* codepoint */
    WINDOW_BUTTON, /* key is the button; action, modifiers, x, y */
    WINDOW_MOVE,   /* x, y */
    WINDOW_SCROLL, /* x, y: steps of the wheel */
    WINDOW_FOCUS   /* action: 1 where the window has the keyboard, 0 where it lost it */
} WindowEventKind;

typedef struct WindowEvent {
    WindowEventKind kind;
    int key, scancode, action, modifiers;
    unsigned codepoint;
    double x, y; /* of the pointer: pixels of the picture from its top left corner */
} WindowEvent;

typedef struct Window {
    GLFWwindow *handle;
    Context context;
    int width, height; /* pixels of the picture; 0 while the window is minimised */
    double scale;      /* pixels per unit of the window's coordinates */
    double pointer[2]; /* where the last event saw it; GLFW would tell where it is by now */
    bool closed;       /* the user wants it gone */
    bool exposed;      /* what it shows was lost, or its size changed */
    WindowEvent *events;
    int event_count, event_capacity;
    double heard;  /* the first of `events` came after this time, */
    double polled; /* and nothing else until this time */
} Window;

/* At most as large as the screen. STATUS_NO_GL where there is no display, or no OpenGL 3.3 on it. The window
 * must stay where it is in memory. */
MUST_CHECK bool window_open(Window *window, const char *title, int width, int height, Error *error);
void window_close(Window *window);

/* Waits up to `seconds` for something to happen; what did is added to `events`, which the caller empties. */
void window_poll(Window *window, double seconds);

/* Looks whether something has happened to the window that was opened last; to be asked in the middle of long
 * work. */
bool window_calls(void);

/* Shows what was drawn on framebuffer 0. */
void window_present(Window *window);

/* How much larger than usual things should be for this screen, in the window's coordinates. */
double window_magnification(const Window *window);

void window_set_title(Window *window, const char *title);
void window_set_clipboard(Window *window, const char *text);
