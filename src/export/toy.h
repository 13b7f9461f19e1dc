/* A scene as the three texts that Shadertoy takes: its tabs Common, Buffer A and Image.
 *
 * The texts are those of the program: what `render` compiles for a direct method of the sky, without what the
 * scene does not use, and with constants in place of uniforms. They also run in `render` and `view`. */
#pragma once

#include "render/plan.h"

/* Writes common.glsl, buffer-a.glsl and image.glsl into the folder, which is made if need be; all of them or
 * none. `command` is the command line for the reader. What a text cannot hold (export/toy_hold.h) is refused.
 * By default the sky is computed by gauss:6, or by a direct method that the scene names, and light by
 * cosine. No OpenGL is needed. */
MUST_CHECK bool toy_export_write(const RenderParams *params, const char *command, const char *folder,
                                 Error *error);
