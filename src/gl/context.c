#include "gl/context.h"

#include "base/budget.h"
#include "base/known.h"
#include "base/text.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static const Backend *const backends[] = {&backend_egl, &backend_osmesa, &backend_glfw};

const Backend *context_backend(int index) {
    return index >= 0 && index < (int)(sizeof backends / sizeof *backends) ? backends[index] : NULL;
}

/* What a process takes before its first pixel, with the tables of the sky and the compiled shaders: 95 to 194
 * MiB with llvmpipe. */
#define DRIVER_BYTES ((size_t)192 << 20)

static bool describe(Context *context, Error *error) {
    const GlApi *gl = &context->gl;
    GLint major = 0, minor = 0;
    gl->GetIntegerv(GL_MAJOR_VERSION, &major);
    gl->GetIntegerv(GL_MINOR_VERSION, &minor);
    const char *renderer = (const char *)gl->GetString(GL_RENDERER);
    const char *version = (const char *)gl->GetString(GL_VERSION);
    snprintf(context->renderer, sizeof context->renderer, "%s", renderer ? renderer : "unknown");
    snprintf(context->version, sizeof context->version, "%s", version ? version : "unknown");
    if (major * 10 + minor < 33) {
        return error_set(error, STATUS_NO_GL, "OpenGL 3.3 is needed, %s is what it has", context->version);
    }
    gl->GetIntegerv(GL_MAX_TEXTURE_SIZE, &context->max_texture_size);
    gl->GenVertexArrays(1, &context->vertex_array);
    gl->BindVertexArray(context->vertex_array);
    return gl_check(gl, "new context", error);
}

static bool open_backend(Context *context, const Backend *backend, Error *error) {
    GlProc (*getproc)(const char *) = NULL;
    *context = (Context){.backend = backend};
    if (backend->open(context, &getproc, error) && gl_api_load(&context->gl, getproc, error) &&
        describe(context, error)) {
        return true;
    }
    error->status = STATUS_NO_GL;
    context_close(context);
    return false;
}

bool context_adopt(Context *context, GlProc (*getproc)(const char *), Error *error) {
    *context = (Context){0};
    if (gl_api_load(&context->gl, getproc, error) && describe(context, error)) return true;
    error->status = STATUS_NO_GL;
    context_close(context);
    return false;
}

/* Drivers end the process where the addresses run out (ulimit -v) while they start or compile: llvmpipe with
 * two threads did so up to 600 MiB, and each thread takes a stack and a heap of its own. */
static bool check_addresses(Error *error) {
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    size_t needed = ((size_t)512 << 20) + ((size_t)128 << 20) * (size_t)(processors < 16 ? processors : 16);
    struct rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >= needed)
        return true;
    return error_set(
        error, STATUS_NO_GL,
        "out of memory: an OpenGL driver needs about %s of addresses, and %s are allowed (ulimit -v)",
        bytes_up(needed).text, bytes_down((size_t)limit.rlim_cur).text);
}

bool context_open(Context *context, const char *name, Error *error) {
    if (!check_addresses(error)) return false;
    if (!budget_take(DRIVER_BYTES, SIZE_MAX, STATUS_USAGE, "the OpenGL driver", error)) return false;
    bool automatic = !name || strcmp(name, "auto") == 0;
    Known known = known_to(automatic ? "" : name, automatic ? 0 : strlen(name));
    Text reasons = {0};
    bool opened = false, found = false;
    known_add(&known, "auto");
    for (int i = 0; context_backend(i) && !opened; i++) {
        const Backend *backend = context_backend(i);
        known_add(&known, backend->name);
        if (!automatic && strcmp(name, backend->name) != 0) continue;
        found = true;
        opened = open_backend(context, backend, error);
        if (!opened) text_print(&reasons, "%s%s: %s", reasons.size ? "; " : "", backend->name, error->text);
    }
    if (!found) {
        known_fail(&known, STATUS_USAGE, error, "unknown backend '%s'", name);
    } else if (!opened) {
        error_set(error, STATUS_NO_GL, "no OpenGL context: %s", text_string(&reasons));
    }
    known_free(&known);
    text_free(&reasons);
    return opened;
}

void context_close(Context *context) {
    if (context->vertex_array) context->gl.DeleteVertexArrays(1, &context->vertex_array);
    if (context->backend) context->backend->close(context);
    *context = (Context){0};
}
