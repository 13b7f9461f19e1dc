/* Float textures; there are no others in this program. */
#pragma once

#include "gl/gl_api.h"

/* Creates a clamped RGBA32F texture. `filter` is GL_NEAREST or GL_LINEAR. `data` has 4 floats a texel, row 0
 * first, or is NULL. */
GLuint texture_create(const GlApi *gl, int width, int height, GLint filter, const float *data);

/* Changes the size and the content of the texture. */
void texture_resize(const GlApi *gl, GLuint texture, int width, int height, const float *data);
