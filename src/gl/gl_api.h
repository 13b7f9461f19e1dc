/* A table of the OpenGL functions in use. Call them as gl->DrawArrays(...).
 *
 * The table is filled through the context's own getproc. A loader library would have to guess the window
 * system, and aborts on an OSMesa context. */
#pragma once

#include "base/error.h"

#include <GL/glcorearb.h>

#define GL_FUNCTIONS(X)                                                                                      \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                                                 \
    X(PFNGLATTACHSHADERPROC, AttachShader)                                                                   \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                             \
    X(PFNGLBINDTEXTUREPROC, BindTexture)                                                                     \
    X(PFNGLBLENDFUNCPROC, BlendFunc)                                                                         \
    X(PFNGLBLITFRAMEBUFFERPROC, BlitFramebuffer)                                                             \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                             \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)                                               \
    X(PFNGLCLEARBUFFERFVPROC, ClearBufferfv)                                                                 \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                                                                 \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                                                                 \
    X(PFNGLCREATESHADERPROC, CreateShader)                                                                   \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                                       \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                                                 \
    X(PFNGLDELETESHADERPROC, DeleteShader)                                                                   \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                                                               \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                                                       \
    X(PFNGLDISABLEPROC, Disable)                                                                             \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)                                                                       \
    X(PFNGLDRAWBUFFERSPROC, DrawBuffers)                                                                     \
    X(PFNGLENABLEPROC, Enable)                                                                               \
    X(PFNGLFINISHPROC, Finish)                                                                               \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)                                                   \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                                                             \
    X(PFNGLGENTEXTURESPROC, GenTextures)                                                                     \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                                                             \
    X(PFNGLGETACTIVEUNIFORMPROC, GetActiveUniform)                                                           \
    X(PFNGLGETERRORPROC, GetError)                                                                           \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                                     \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                                                         \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                                                   \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                                                           \
    X(PFNGLGETSHADERIVPROC, GetShaderiv)                                                                     \
    X(PFNGLGETSTRINGPROC, GetString)                                                                         \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                                                       \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                                                                     \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                                                                     \
    X(PFNGLREADBUFFERPROC, ReadBuffer)                                                                       \
    X(PFNGLREADPIXELSPROC, ReadPixels)                                                                       \
    X(PFNGLSCISSORPROC, Scissor)                                                                             \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                                                                   \
    X(PFNGLTEXIMAGE2DPROC, TexImage2D)                                                                       \
    X(PFNGLTEXPARAMETERIPROC, TexParameteri)                                                                 \
    X(PFNGLUNIFORM1FPROC, Uniform1f)                                                                         \
    X(PFNGLUNIFORM1FVPROC, Uniform1fv)                                                                       \
    X(PFNGLUNIFORM1IPROC, Uniform1i)                                                                         \
    X(PFNGLUNIFORM1UIPROC, Uniform1ui)                                                                       \
    X(PFNGLUNIFORM3FPROC, Uniform3f)                                                                         \
    X(PFNGLUNIFORM4FPROC, Uniform4f)                                                                         \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                                                       \
    X(PFNGLVIEWPORTPROC, Viewport)

typedef struct GlApi {
#define X(type, name) type name;
    GL_FUNCTIONS(X)
#undef X
} GlApi;

typedef void (*GlProc)(void);

/* Fills the table. Fails with STATUS_NO_GL if a function is missing. */
MUST_CHECK bool gl_api_load(GlApi *gl, GlProc (*getproc)(const char *name), Error *error);

/* Fails with "WHAT: OpenGL error 0x0505 (out of memory)" if OpenGL has an error pending. */
MUST_CHECK bool gl_check(const GlApi *gl, const char *what, Error *error);
