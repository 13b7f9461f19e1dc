/* An OpenGL 3.3 core context without a visible window, from the first backend that gives one.
 * It is current on the calling thread from context_open to context_close; one at a time. */
#pragma once

#include "gl/gl_api.h"

typedef struct Context Context;

/* A way to a context: functions in a file of its own, listed in one table (context.c). */
typedef struct Backend {
    const char *name; /* as --backend takes it */
    /* Makes a context, makes it current, sets `detail` and `state`, and gives the getproc.
     * Fails with STATUS_NO_GL and the reason; close() then cleans up what was made. */
    bool (*open)(Context *context, GlProc (**getproc)(const char *), Error *error);
    void (*close)(Context *context);
} Backend;

struct Context {
    GlApi gl;
    const Backend *backend;
    void *state;        /* the backend's own */
    char detail[160];   /* which device or platform of the backend */
    char renderer[160]; /* GL_RENDERER */
    char version[160];  /* GL_VERSION */
    int max_texture_size;
    GLuint vertex_array; /* empty: every pass is one triangle made from gl_VertexID */
};

/* `name` is "auto" (NULL also) or a backend's. STATUS_NO_GL names every reason; STATUS_USAGE an unknown name.
 */
MUST_CHECK bool context_open(Context *context, const char *name, Error *error);

/* For a context that the caller has made and made current, a window's: fills the table and describes it. To
 * be closed by context_close before the caller destroys it. */
MUST_CHECK bool context_adopt(Context *context, GlProc (*getproc)(const char *), Error *error);
void context_close(Context *context);

/* The table, in the order in which auto tries it; NULL past the end. */
const Backend *context_backend(int index);

extern const Backend backend_egl, backend_osmesa, backend_glfw;
