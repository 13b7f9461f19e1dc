/* OSMesa: Mesa renders into plain memory. Mesa 25.1 dropped it. The library is therefore opened at run time,
 * and this file declares the few names that its header would have. The environment variable MAGICHOUR_OSMESA
 * names another library file. */
#include "base/memory.h"
#include "gl/context.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    OSMESA_FORMAT = 0x22,
    OSMESA_PROFILE = 0x33,
    OSMESA_CORE_PROFILE = 0x34,
    OSMESA_CONTEXT_MAJOR_VERSION = 0x36,
    OSMESA_CONTEXT_MINOR_VERSION = 0x37
};

typedef struct OsMesa {
    void *library;
    void *(*create)(const int *attributes, void *share);
    GLboolean (*make_current)(void *context, void *buffer, GLenum type, GLsizei width, GLsizei height);
    void (*destroy)(void *context);
    GlProc (*getproc)(const char *name);
    void *context;
    /* OSMesa requires a drawable. All drawing goes to framebuffer objects. */
    GLubyte buffer[4];
} OsMesa;

static bool open_library(OsMesa *mesa, char *name, size_t size, Error *error) {
    const char *wanted = getenv("MAGICHOUR_OSMESA");
    const char *candidates[] = {wanted ? wanted : "libOSMesa.so.8", wanted ? NULL : "libOSMesa.so.6",
                                wanted ? NULL : "libOSMesa.so"};
    for (int i = 0; i < 3 && candidates[i] && !mesa->library; i++) {
        mesa->library = dlopen(candidates[i], RTLD_NOW | RTLD_LOCAL);
        snprintf(name, size, "%s", candidates[i]);
    }
    return mesa->library ? true : error_set(error, STATUS_NO_GL, "%s", dlerror());
}

static bool resolve(OsMesa *mesa, void *slot, const char *name, Error *error) {
    void *symbol = dlsym(mesa->library, name);
    if (!symbol) return error_set(error, STATUS_NO_GL, "%s is missing", name);
    memcpy(slot, &symbol, sizeof symbol);
    return true;
}

static bool osmesa_open(Context *context, GlProc (**getproc)(const char *), Error *error) {
    static const int attributes[] = {OSMESA_FORMAT,
                                     GL_RGBA,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     3,
                                     0};
    OsMesa *mesa = context->state = memory_get(1, sizeof *mesa);
    if (!open_library(mesa, context->detail, sizeof context->detail, error)) return false;
    if (!resolve(mesa, &mesa->create, "OSMesaCreateContextAttribs", error) ||
        !resolve(mesa, &mesa->make_current, "OSMesaMakeCurrent", error) ||
        !resolve(mesa, &mesa->destroy, "OSMesaDestroyContext", error) ||
        !resolve(mesa, &mesa->getproc, "OSMesaGetProcAddress", error)) {
        return false;
    }
    mesa->context = mesa->create(attributes, NULL);
    if (!mesa->context) return error_set(error, STATUS_NO_GL, "OSMesa gives no 3.3 core context");
    if (!mesa->make_current(mesa->context, mesa->buffer, GL_UNSIGNED_BYTE, 1, 1)) {
        return error_set(error, STATUS_NO_GL, "OSMesaMakeCurrent failed");
    }
    *getproc = mesa->getproc;
    return true;
}

static void osmesa_close(Context *context) {
    OsMesa *mesa = context->state;
    if (!mesa) return;
    if (mesa->context) {
        mesa->make_current(NULL, NULL, GL_UNSIGNED_BYTE, 0, 0);
        mesa->destroy(mesa->context);
    }
    /* The library stays open: see context_egl.c. */
    free(mesa);
}

const Backend backend_osmesa = {.name = "osmesa", .open = osmesa_open, .close = osmesa_close};
