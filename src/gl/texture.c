#include "gl/texture.h"

/* Textures are changed on a unit that no program's sampler gets, so that the textures of the program in use
 * stay bound. OpenGL 3.3 promises 48 units in all and 16 for a fragment program. */
enum { SPARE_UNIT = 40 };

static void bind_to_change(const GlApi *gl, GLuint texture) {
    gl->ActiveTexture(GL_TEXTURE0 + SPARE_UNIT);
    gl->BindTexture(GL_TEXTURE_2D, texture);
}

static void done_changing(const GlApi *gl) {
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->ActiveTexture(GL_TEXTURE0);
}

void texture_resize(const GlApi *gl, GLuint texture, int width, int height, const float *data) {
    bind_to_change(gl, texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, data);
    done_changing(gl);
}

GLuint texture_create(const GlApi *gl, int width, int height, GLint filter, const float *data) {
    GLuint texture = 0;
    gl->GenTextures(1, &texture);
    texture_resize(gl, texture, width, height, data);
    bind_to_change(gl, texture);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    done_changing(gl);
    return texture;
}
