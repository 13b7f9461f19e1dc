/* Float textures, the one kind there is here. */
#pragma once

#include "gl/gl_api.h"

/* A clamped RGBA32F texture. `filter` is GL_NEAREST or GL_LINEAR; `data` NULL or 4
 * floats a texel, row 0 first. */
GLuint texture_create(const GlApi *gl, int width, int height, GLint filter, const float *data);

/* Gives the texture another size and content. */
void texture_resize(const GlApi *gl, GLuint texture, int width, int height, const float *data);
