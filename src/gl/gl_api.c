#include "gl/gl_api.h"

#include <string.h>

static bool load_one(void *slot, const char *name, GlProc (*getproc)(const char *), Error *error) {
    GlProc proc = getproc(name);
    if (!proc) return error_set(error, STATUS_NO_GL, "OpenGL function %s is missing", name);
    memcpy(slot, &proc, sizeof proc);
    return true;
}

bool gl_api_load(GlApi *gl, GlProc (*getproc)(const char *name), Error *error) {
#define X(type, name)                                                                                        \
    if (!load_one(&gl->name, "gl" #name, getproc, error)) return false;
    GL_FUNCTIONS(X)
#undef X
    return true;
}

static const char *error_words(GLenum code) {
    switch (code) {
    case GL_INVALID_ENUM:
        return "invalid enum";
    case GL_INVALID_VALUE:
        return "invalid value";
    case GL_INVALID_OPERATION:
        return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "invalid framebuffer operation";
    case GL_OUT_OF_MEMORY:
        return "out of memory";
    case GL_CONTEXT_LOST:
        return "context lost";
    default:
        return "unknown";
    }
}

bool gl_check(const GlApi *gl, const char *what, Error *error) {
    GLenum code = gl->GetError();
    if (code == GL_NO_ERROR) return true;
    /* A lost context reports errors for ever, so the number of calls is limited. */
    for (int i = 0; i < 16 && gl->GetError() != GL_NO_ERROR; i++) {
    }
    return error_set(error, STATUS_FAILURE, "%s: OpenGL error 0x%04x (%s)", what, code, error_words(code));
}
