#include "gl/target.h"

#include "gl/texture.h"

static bool create_side(Target *target, int side, Error *error) {
    static const GLenum outputs[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
    const GlApi *gl = target->gl;
    gl->GenFramebuffers(1, &target->framebuffer[side]);
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer[side]);
    for (int i = 0; i < target->count; i++) {
        GLuint *texture = &target->textures[side][i];
        *texture = texture_create(gl, target->width, target->height, GL_NEAREST, NULL);
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, outputs[i], GL_TEXTURE_2D, *texture, 0);
    }
    gl->DrawBuffers(target->count, outputs);
    if (!gl_check(gl, "float textures to draw into", error)) return false;
    GLenum status = gl->CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        return error_set(error, STATUS_NO_GL, "this OpenGL cannot render to float textures (0x%04x)", status);
    }
    return true;
}

bool target_create(Target *target, const Context *context, int width, int height, int count, Error *error) {
    *target = (Target){.gl = &context->gl, .width = width, .height = height, .count = count};
    if (width > context->max_texture_size || height > context->max_texture_size) {
        return error_set(error, STATUS_USAGE, "picture size %dx%d: this OpenGL's limit is %dx%d", width,
                         height, context->max_texture_size, context->max_texture_size);
    }
    if (!create_side(target, 0, error) || !create_side(target, 1, error)) {
        target_destroy(target);
        return false;
    }
    target_clear(target);
    return true;
}

void target_destroy(Target *target) {
    if (!target->gl) return;
    target->gl->DeleteFramebuffers(2, target->framebuffer);
    for (int side = 0; side < 2; side++) target->gl->DeleteTextures(target->count, target->textures[side]);
    *target = (Target){0};
}

void target_clear(Target *target) {
    static const GLfloat zero[4] = {0};
    for (int side = 0; side < 2; side++) {
        target->gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer[side]);
        for (int i = 0; i < target->count; i++) target->gl->ClearBufferfv(GL_COLOR, i, zero);
    }
}

void target_begin(const Target *target, const Program *program, const char *const *names, const int *units) {
    const GlApi *gl = target->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer[1 - target->front]);
    gl->Viewport(0, 0, target->width, target->height);
    for (int i = 0; i < target->count; i++) {
        gl->ActiveTexture(GL_TEXTURE0 + (GLenum)units[i]);
        gl->BindTexture(GL_TEXTURE_2D, target->textures[target->front][i]);
        program_set_int(program, names[i], units[i]);
    }
    gl->ActiveTexture(GL_TEXTURE0);
}

void target_swap(Target *target) {
    target->front = 1 - target->front;
}

bool target_read(const Target *target, int i, float *rgba, Error *error) {
    const GlApi *gl = target->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer[target->front]);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0 + (GLenum)i);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->ReadPixels(0, 0, target->width, target->height, GL_RGBA, GL_FLOAT, rgba);
    return gl_check(gl, "reading a picture back", error);
}
