/* EGL without a display. It tries each EGL device, hardware before software, and then Mesa's surfaceless
 * platform. EGL devices are what works on NVIDIA. The library is opened at run time, so that a machine
 * without it can use the other backends. */
#include "base/memory.h"
#include "base/text.h"
#include "gl/context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EGL_FUNCTIONS(X)                                                                                     \
    X(EGLBoolean, BindAPI, (EGLenum))                                                                        \
    X(EGLBoolean, ChooseConfig, (EGLDisplay, const EGLint *, EGLConfig *, EGLint, EGLint *))                 \
    X(EGLContext, CreateContext, (EGLDisplay, EGLConfig, EGLContext, const EGLint *))                        \
    X(EGLBoolean, DestroyContext, (EGLDisplay, EGLContext))                                                  \
    X(EGLint, GetError, (void))                                                                              \
    X(GlProc, GetProcAddress, (const char *))                                                                \
    X(EGLBoolean, Initialize, (EGLDisplay, EGLint *, EGLint *))                                              \
    X(EGLBoolean, MakeCurrent, (EGLDisplay, EGLSurface, EGLSurface, EGLContext))                             \
    X(const char *, QueryString, (EGLDisplay, EGLint))                                                       \
    X(EGLBoolean, ReleaseThread, (void))                                                                     \
    X(EGLBoolean, Terminate, (EGLDisplay))

typedef struct Egl {
    void *library;
#define X(result, name, arguments) result(*name) arguments;
    EGL_FUNCTIONS(X)
#undef X
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display;
    /* NULL without the extension EGL_EXT_device_enumeration. */
    PFNEGLQUERYDEVICESEXTPROC query_devices;
    /* NULL without the extension EGL_EXT_device_query. */
    PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string;
    EGLDisplay display;
    EGLContext context;
} Egl;

static bool resolve(Egl *egl, void *slot, const char *name, Error *error) {
    void *symbol = dlsym(egl->library, name);
    if (!symbol) return error_set(error, STATUS_NO_GL, "libEGL.so.1 lacks %s", name);
    memcpy(slot, &symbol, sizeof symbol);
    return true;
}

static bool load(Egl *egl, Error *error) {
    egl->library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!egl->library) return error_set(error, STATUS_NO_GL, "%s", dlerror());
#define X(result, name, arguments)                                                                           \
    if (!resolve(egl, &egl->name, "egl" #name, error)) return false;
    EGL_FUNCTIONS(X)
#undef X
    egl->get_platform_display =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)egl->GetProcAddress("eglGetPlatformDisplayEXT");
    egl->query_devices = (PFNEGLQUERYDEVICESEXTPROC)egl->GetProcAddress("eglQueryDevicesEXT");
    egl->query_device_string = (PFNEGLQUERYDEVICESTRINGEXTPROC)egl->GetProcAddress("eglQueryDeviceStringEXT");
    if (!egl->get_platform_display) {
        return error_set(error, STATUS_NO_GL, "eglGetPlatformDisplayEXT is missing");
    }
    return true;
}

/* Makes a context on this display and makes it current. If that fails, everything is freed and `error` has
 * the reason. */
static bool open_display(Egl *egl, EGLenum platform, void *native, Error *error) {
    static const EGLint config_attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                               EGL_NONE};
    static const EGLint context_attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                                3,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                3,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                EGL_NONE};
    const char *step = "eglGetPlatformDisplay";
    EGLConfig config = NULL;
    EGLint configs = 0;
    egl->context = EGL_NO_CONTEXT;
    egl->display = egl->get_platform_display(platform, native, NULL);
    if (egl->display == EGL_NO_DISPLAY) goto fail;
    step = "eglInitialize";
    if (!egl->Initialize(egl->display, NULL, NULL)) goto fail;
    step = "eglBindAPI(OpenGL)";
    if (!egl->BindAPI(EGL_OPENGL_API)) goto fail;
    step = "eglChooseConfig";
    if (!egl->ChooseConfig(egl->display, config_attributes, &config, 1, &configs) || configs < 1) goto fail;
    step = "eglCreateContext(3.3 core)";
    egl->context = egl->CreateContext(egl->display, config, EGL_NO_CONTEXT, context_attributes);
    if (egl->context == EGL_NO_CONTEXT) goto fail;
    step = "eglMakeCurrent(no surface)";
    if (!egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl->context)) goto fail;
    return true;
fail:
    error_set(error, STATUS_NO_GL, "%s failed (0x%04x)", step, (unsigned)egl->GetError());
    if (egl->context != EGL_NO_CONTEXT) egl->DestroyContext(egl->display, egl->context);
    if (egl->display != EGL_NO_DISPLAY) egl->Terminate(egl->display);
    egl->context = EGL_NO_CONTEXT;
    egl->display = EGL_NO_DISPLAY;
    return false;
}

static bool is_software(const Egl *egl, EGLDeviceEXT device) {
    const char *extensions =
        egl->query_device_string ? egl->query_device_string(device, EGL_EXTENSIONS) : NULL;
    return extensions && strstr(extensions, "EGL_MESA_device_software");
}

static bool open_device(Egl *egl, Context *context, Text *reasons) {
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    if (!egl->query_devices || !egl->query_devices(16, devices, &count) || count < 1) {
        text_print(reasons, "no EGL device");
        return false;
    }
    for (int software = 0; software < 2; software++) {
        for (int i = 0; i < count; i++) {
            Error error;
            if (is_software(egl, devices[i]) != (software == 1)) continue;
            if (open_display(egl, EGL_PLATFORM_DEVICE_EXT, devices[i], &error)) {
                snprintf(context->detail, sizeof context->detail, "device %d%s", i,
                         software ? " (software)" : "");
                return true;
            }
            text_print(reasons, "%sdevice %d: %s", reasons->size ? ", " : "", i, error.text);
        }
    }
    return false;
}

static bool egl_open(Context *context, GlProc (**getproc)(const char *), Error *error) {
    Egl *egl = context->state = memory_get(1, sizeof *egl);
    Text reasons = {0};
    if (!load(egl, error)) return false;
    bool opened = open_device(egl, context, &reasons);
    if (!opened) {
        opened = open_display(egl, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, error);
        if (opened) {
            snprintf(context->detail, sizeof context->detail, "surfaceless");
        } else {
            text_print(&reasons, ", surfaceless: %s", error->text);
            error_set(error, STATUS_NO_GL, "%s", text_string(&reasons));
        }
    }
    text_free(&reasons);
    *getproc = egl->GetProcAddress;
    return opened;
}

static void egl_close(Context *context) {
    Egl *egl = context->state;
    if (!egl) return;
    if (egl->context) {
        egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl->DestroyContext(egl->display, egl->context);
        egl->Terminate(egl->display);
        egl->ReleaseThread();
    }
    /* The library stays open, because drivers leave thread-local destructors behind that must not be
     * unmapped. */
    free(egl);
}

const Backend backend_egl = {.name = "egl", .open = egl_open, .close = egl_close};
