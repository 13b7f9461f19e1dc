/* An OpenGL 3.3 core context without a visible window, from the first backend that has one.
 *
 * The context is current on the calling thread from context_open() to context_close(). There may be one at a
 * time. */
#pragma once

#include "gl/gl_api.h"

typedef struct Context Context;

/* A way to get a context. Each backend has a file of its own; context.c lists them in a table. */
typedef struct Backend {
    /* The name that --backend takes. */
    const char *name;
    /* Makes a context, makes it current, sets `detail` and `state`, and sets *getproc.
     * Fails with STATUS_NO_GL and the reason. The caller then calls close(), which frees what was made. */
    bool (*open)(Context *context, GlProc (**getproc)(const char *), Error *error);
    void (*close)(Context *context);
} Backend;

struct Context {
    GlApi gl;
    const Backend *backend;
    /* Belongs to the backend. */
    void *state;
    /* Names the device or platform of the backend. */
    char detail[160];
    /* GL_RENDERER and GL_VERSION. */
    char renderer[160];
    char version[160];
    int max_texture_size;
    /* Has no attributes: every pass draws one triangle that is made from gl_VertexID. */
    GLuint vertex_array;
};

/* Opens a context. `name` is a backend's name, or "auto" or NULL for the first that works. Fails with
 * STATUS_NO_GL and the reason of every backend, or with STATUS_USAGE if the name is unknown. */
MUST_CHECK bool context_open(Context *context, const char *name, Error *error);

/* Fills `context` for a context that the caller has made and made current, such as a window's. Call
 * context_close() before you destroy that context. */
MUST_CHECK bool context_adopt(Context *context, GlProc (*getproc)(const char *), Error *error);
void context_close(Context *context);

/* Returns a backend of the table, in the order in which "auto" tries them, or NULL past the end. */
const Backend *context_backend(int index);

extern const Backend backend_egl, backend_osmesa, backend_glfw;
