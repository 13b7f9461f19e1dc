#include "gl/target.h"

#include "base/budget.h"
#include "base/memory.h"
#include "gl/texture.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* Makes all textures of the bound framebuffer the ones that are drawn into. */
static void draw_to_all(const Target *target) {
    GLenum buffers[TARGET_TEXTURES];
    for (int i = 0; i < TARGET_TEXTURES; i++)
        buffers[i] = target->textures[0][i] ? GL_COLOR_ATTACHMENT0 + (GLenum)i : GL_NONE;
    target->gl->DrawBuffers(TARGET_TEXTURES, buffers);
}

static bool create_side(Target *target, int side, unsigned outputs, Error *error) {
    const GlApi *gl = target->gl;
    gl->GenFramebuffers(1, &target->framebuffer[side]);
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer[side]);
    for (int i = 0; i < TARGET_TEXTURES; i++) {
        GLuint *texture = &target->textures[side][i];
        if (!(outputs >> i & 1)) continue;
        *texture = texture_create(gl, target->width, target->height, GL_NEAREST, NULL);
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + (GLenum)i, GL_TEXTURE_2D, *texture,
                                 0);
    }
    draw_to_all(target);
    if (!gl_check(gl, "float textures to draw into", error)) return false;
    GLenum status = gl->CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        return error_set(error, STATUS_NO_GL, "this OpenGL cannot render to float textures (0x%04x)", status);
    }
    return true;
}

/* What a pixel of an output takes on both sides, and what reading and writing a picture takes at its end: by
 * the memory of processes that drew scenes, and somewhat more. */
enum { BYTES_AN_OUTPUT = 32, BYTES_TO_READ = 72 };

static bool take_memory(Target *target, unsigned outputs, Error *error) {
    size_t pixel = BYTES_TO_READ;
    char what[64];
    for (; outputs; outputs >>= 1) pixel += (outputs & 1) * BYTES_AN_OUTPUT;
    snprintf(what, sizeof what, "a picture of %dx%d pixels", target->width, target->height);
    size_t bytes = pixel * (size_t)target->width * (size_t)target->height;
    if (!budget_take(bytes, SIZE_MAX, STATUS_USAGE, what, error)) return false;
    target->memory = bytes;
    return true;
}

bool target_create(Target *target, const Context *context, int width, int height, unsigned outputs,
                   Error *error) {
    *target = (Target){.gl = &context->gl, .width = width, .height = height};
    if (width > context->max_texture_size || height > context->max_texture_size) {
        return error_set(error, STATUS_USAGE, "picture size %dx%d: this OpenGL's limit is %dx%d", width,
                         height, context->max_texture_size, context->max_texture_size);
    }
    if (!take_memory(target, outputs, error) || !create_side(target, 0, outputs, error) ||
        !create_side(target, 1, outputs, error)) {
        target_destroy(target);
        return false;
    }
    target_clear(target);
    return true;
}

void target_destroy(Target *target) {
    if (!target->gl) return;
    budget_give(target->memory);
    target->gl->DeleteFramebuffers(2, target->framebuffer);
    for (int side = 0; side < 2; side++) target->gl->DeleteTextures(TARGET_TEXTURES, target->textures[side]);
    *target = (Target){0};
}

static void clear_side(Target *target, int side) {
    static const GLfloat zero[4] = {0};
    target->gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer[side]);
    for (int i = 0; i < TARGET_TEXTURES; i++) {
        if (target->textures[side][i]) target->gl->ClearBufferfv(GL_COLOR, i, zero);
    }
}

void target_clear(Target *target) {
    for (int side = 0; side < 2; side++) clear_side(target, side);
}

void target_clear_front(Target *target) {
    clear_side(target, target->front);
}

void target_clear_back(Target *target) {
    clear_side(target, 1 - target->front);
}

void target_begin(const Target *target, const Program *program, const char *const *names) {
    const GlApi *gl = target->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer[1 - target->front]);
    gl->Viewport(0, 0, target->width, target->height);
    for (int i = 0; i < TARGET_TEXTURES; i++) {
        if (!target->textures[0][i] || !names[i]) continue;
        program_set_texture(program, names[i], target->textures[target->front][i]);
    }
}

void target_keep(Target *target, const Rectangle *regions, int count) {
    const GlApi *gl = target->gl;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer[target->front]);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target->framebuffer[1 - target->front]);
    for (int i = 0; i < TARGET_TEXTURES; i++) {
        GLenum none_before[TARGET_TEXTURES] = {GL_NONE};
        if (!target->textures[0][i]) continue;
        none_before[i] = GL_COLOR_ATTACHMENT0 + (GLenum)i;
        gl->ReadBuffer(none_before[i]);
        gl->DrawBuffers(i + 1, none_before);
        for (int k = 0; k < count; k++) {
            const Rectangle *r = &regions[k];
            int right = r->x + r->width, bottom = r->y + r->height;
            gl->BlitFramebuffer(r->x, r->y, right, bottom, r->x, r->y, right, bottom, GL_COLOR_BUFFER_BIT,
                                GL_NEAREST);
        }
    }
    draw_to_all(target);
}

void target_swap(Target *target) {
    target->front = 1 - target->front;
}

static bool read_rectangle(const Target *target, int i, const int rectangle[4], float *rgba, Error *error) {
    const GlApi *gl = target->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer[target->front]);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0 + (GLenum)i);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->ReadPixels(rectangle[0], rectangle[1], rectangle[2], rectangle[3], GL_RGBA, GL_FLOAT, rgba);
    return gl_check(gl, "reading a picture back", error);
}

bool target_read(const Target *target, int i, float *rgba, Error *error) {
    const int all[4] = {0, 0, target->width, target->height};
    return read_rectangle(target, i, all, rgba, error);
}

bool target_read_pixel(const Target *target, int i, int x, int y, float rgba[4], Error *error) {
    const int pixel[4] = {x, y, 1, 1};
    return read_rectangle(target, i, pixel, rgba, error);
}

bool target_archive(Target *target, Archive *archive, Error *error) {
    size_t values = 4 * (size_t)target->width * (size_t)target->height;
    float *texels = memory_get(values, sizeof *texels);
    bool ok = true;
    for (int i = 0; ok && i < TARGET_TEXTURES; i++) {
        GLuint texture = target->textures[target->front][i];
        if (!texture) continue;
        if (!archive_loads(archive)) ok = target_read(target, i, texels, error);
        archive_bytes(archive, texels, values * sizeof *texels);
        if (archive_loads(archive))
            texture_resize(target->gl, texture, target->width, target->height, texels);
    }
    free(texels);
    return ok && gl_check(target->gl, "saving or loading a film", error);
}
