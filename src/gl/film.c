#include "gl/film.h"

#include "gl/texture.h"

#include <math.h>
#include <stdlib.h>

static bool create_side(Film *film, int side, Error *error) {
    static const GLenum targets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    const GlApi *gl = film->gl;
    film->sum[side] = texture_create(gl, film->width, film->height, GL_NEAREST, NULL);
    film->rest[side] = texture_create(gl, film->width, film->height, GL_NEAREST, NULL);
    gl->GenFramebuffers(1, &film->framebuffer[side]);
    gl->BindFramebuffer(GL_FRAMEBUFFER, film->framebuffer[side]);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, film->sum[side], 0);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, film->rest[side], 0);
    gl->DrawBuffers(2, targets);
    if (!gl_check(gl, "film", error)) return false;
    GLenum status = gl->CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        return error_set(error, STATUS_NO_GL, "this OpenGL cannot render to float textures (0x%04x)", status);
    }
    return true;
}

bool film_create(Film *film, const Context *context, int width, int height, Error *error) {
    *film = (Film){.gl = &context->gl, .width = width, .height = height};
    if (width > context->max_texture_size || height > context->max_texture_size) {
        return error_set(error, STATUS_USAGE, "picture size %dx%d: this OpenGL's limit is %dx%d", width,
                         height, context->max_texture_size, context->max_texture_size);
    }
    if (!create_side(film, 0, error) || !create_side(film, 1, error)) {
        film_destroy(film);
        return false;
    }
    film_reset(film);
    return true;
}

void film_destroy(Film *film) {
    if (!film->gl) return;
    film->gl->DeleteFramebuffers(2, film->framebuffer);
    film->gl->DeleteTextures(2, film->sum);
    film->gl->DeleteTextures(2, film->rest);
    *film = (Film){0};
}

void film_reset(Film *film) {
    static const GLfloat zero[4] = {0};
    for (int side = 0; side < 2; side++) {
        film->gl->BindFramebuffer(GL_FRAMEBUFFER, film->framebuffer[side]);
        film->gl->ClearBufferfv(GL_COLOR, 0, zero);
        film->gl->ClearBufferfv(GL_COLOR, 1, zero);
    }
    film->samples = 0;
}

void film_begin(Film *film, const Program *program) {
    const GlApi *gl = film->gl;
    int back = 1 - film->front;
    gl->BindFramebuffer(GL_FRAMEBUFFER, film->framebuffer[back]);
    gl->Viewport(0, 0, film->width, film->height);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D, film->sum[film->front]);
    gl->ActiveTexture(GL_TEXTURE1);
    gl->BindTexture(GL_TEXTURE_2D, film->rest[film->front]);
    gl->ActiveTexture(GL_TEXTURE0);
    program_set_int(program, "film_sum", 0);
    program_set_int(program, "film_rest", 1);
    program_set_uint(program, "film_zero", 0);
}

void film_commit(Film *film, uint64_t samples) {
    film->front = 1 - film->front;
    film->samples += samples;
}

static void read_attachment(const Film *film, GLenum attachment, float *rgba) {
    const GlApi *gl = film->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, film->framebuffer[film->front]);
    gl->ReadBuffer(attachment);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->ReadPixels(0, 0, film->width, film->height, GL_RGBA, GL_FLOAT, rgba);
}

bool film_read(const Film *film, Image *image, FilmCount *count, Error *error) {
    size_t pixels = (size_t)film->width * (size_t)film->height;
    float *rest = memory_get(pixels * 4, sizeof *rest);
    double accepted = 0, rejected = 0;
    *image = image_create(film->width, film->height);
    read_attachment(film, GL_COLOR_ATTACHMENT0, image->rgba);
    read_attachment(film, GL_COLOR_ATTACHMENT1, rest);
    bool ok = gl_check(film->gl, "reading the film", error);
    for (size_t i = 0; ok && i < pixels; i++) {
        float *pixel = image->rgba + 4 * i;
        double weight = pixel[3];
        accepted += weight;
        rejected += rest[4 * i + 3];
        for (int c = 0; c < 3; c++) {
            pixel[c] =
                weight > 0 ? (float)(((double)pixel[c] + (double)rest[4 * i + (size_t)c]) / weight) : 0.0f;
        }
        pixel[3] = weight > 0 ? 1.0f : 0.0f;
    }
    free(rest);
    if (!ok) image_free(image);
    *count = (FilmCount){.accepted = (uint64_t)llround(accepted), .rejected = (uint64_t)llround(rejected)};
    return ok;
}
