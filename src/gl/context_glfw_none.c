/* Stands in for context_glfw.c in a build without the window (WINDOW=0). */
#include "gl/context.h"

static bool none_open(Context *context, GlProc (**getproc)(const char *), Error *error) {
    (void)context, (void)getproc;
    return error_set(error, STATUS_NO_GL, "this build has no GLFW (WINDOW=0)");
}

static void none_close(Context *context) {
    (void)context;
}

const Backend backend_glfw = {.name = "glfw", .open = none_open, .close = none_close};
