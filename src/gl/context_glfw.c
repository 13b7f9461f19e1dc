/* A hidden GLFW window. This backend is tried last. It serves machines that have a display and no other way.
 */
#include "gl/context.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <stdio.h>

static bool glfw_error(const char *step, Error *error) {
    const char *reason = NULL;
    glfwGetError(&reason);
    return error_set(error, STATUS_NO_GL, "%s failed: %s", step, reason ? reason : "no reason given");
}

static bool glfw_open(Context *context, GlProc (**getproc)(const char *), Error *error) {
    if (!glfwInit()) return glfw_error("glfwInit", error);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    GLFWwindow *window = glfwCreateWindow(16, 16, "magichour", NULL, NULL);
    if (!window) return glfw_error("glfwCreateWindow", error);
    context->state = window;
    glfwMakeContextCurrent(window);
    snprintf(context->detail, sizeof context->detail, "hidden window, GLFW %s", glfwGetVersionString());
    *getproc = glfwGetProcAddress;
    return true;
}

static void glfw_close(Context *context) {
    if (context->state) glfwDestroyWindow(context->state);
    glfwTerminate();
}

const Backend backend_glfw = {.name = "glfw", .open = glfw_open, .close = glfw_close};
