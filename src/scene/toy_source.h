/* The GLSL text of a file that is no scene but paints a picture by itself: a Shadertoy program with
 * mainImage(), or a fragment shader with main() of its own, as in The Book of Shaders. The text is changed
 * where the dialect of WebGL differs from GLSL 3.30, and no line is added or lost:
 *
 * - #version is left out, and #extension stands where the language wants it;
 * - gl_FragColor, texture2D() and iGlobalTime have the names of today;
 * - main() and what it writes to an `out` variable are called by glsl/pass/shadertoy.glsl;
 * - uniforms that the file declares itself get the values of Shadertoy's inputs (scene/toy_input.h);
 * - variables that the file does not set are 0 (source/glsl_zero.h). */
#pragma once

#include "scene/scene_file.h"

typedef struct ToyParams {
    const SceneFile *file;
    /* Its Buffer A in place of the file itself. */
    bool buffer;
    /* Leaves variables as they are. */
    bool without_zero;
} ToyParams;

/* Makes the text of glsl/pass/shadertoy.glsl with the file in it. Appends to `notes` what the file will not
 * get, a line each with its place. STATUS_SCENE with the place names files of another kind (ISF, shaders with
 * inputs from a vertex shader). */
MUST_CHECK bool toy_source_create(GlslSource *source, Text *notes, const ToyParams *params, Error *error);
