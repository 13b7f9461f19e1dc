#include "gl/film.h"

#include "base/budget.h"
#include "base/memory.h"
#include "gl/texture.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static size_t pixel_count(const Film *film) {
    return (size_t)film->width * (size_t)film->height;
}

static void create_texture(const Film *film, GLuint *texture, GLuint *framebuffer) {
    const GlApi *gl = film->target.gl;
    *texture = texture_create(gl, film->width, film->height, GL_NEAREST, NULL);
    gl->GenFramebuffers(1, framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, *framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, *texture, 0);
}

static void clear_light(Film *film) {
    film->light_paths = 0;
    if (film->light) film_light_clear(film->light);
}

/* The second sum on both sides and joined, and what the light that is left to chance takes when it is
 * read. */
static bool take_memory(Film *film, Error *error) {
    size_t pixel = (film->parts & FILM_LIGHT ? 48U : 0U) + (film->parts & FILM_CHANCE ? 36U : 0U);
    size_t bytes = pixel * pixel_count(film);
    if (!budget_take(bytes, SIZE_MAX, STATUS_USAGE, "the light that is traced", error)) return false;
    film->memory = bytes;
    return true;
}

bool film_create(Film *film, const Context *context, int width, int height, unsigned parts, Error *error) {
    unsigned outputs = 1U << FILM_TEXTURE_SUM | 1U << FILM_TEXTURE_REST;
    if (parts & FILM_SCATTER) outputs |= 1U << FILM_TEXTURE_SCATTER;
    if (parts & FILM_SEARCH) outputs |= 1U << FILM_TEXTURE_SEARCH;
    if (parts & FILM_CHANCE) outputs |= 1U << FILM_TEXTURE_CHANCE | 1U << FILM_TEXTURE_SQUARES;
    if (parts & FILM_REJECTS) outputs |= 1U << FILM_TEXTURE_REJECTS;
    *film = (Film){.width = width, .height = height, .parts = parts, .light_scale = 1};
    if (!target_create(&film->target, context, width, height, outputs, error)) return false;
    if (!take_memory(film, error)) {
        film_destroy(film);
        return false;
    }
    if (parts & FILM_LIGHT) {
        film->light = film_light_create(&context->gl, width, height);
        create_texture(film, &film->joined, &film->joined_framebuffer);
    }
    if (gl_check(film->target.gl, "a film for points of light", error)) return true;
    film_destroy(film);
    return false;
}

void film_destroy(Film *film) {
    if (film->light) {
        film_light_destroy(film->light, film->target.gl);
        film->target.gl->DeleteFramebuffers(1, &film->joined_framebuffer);
        film->target.gl->DeleteTextures(1, &film->joined);
    }
    budget_give(film->memory);
    target_destroy(&film->target);
    *film = (Film){0};
}

void film_clear_next(Film *film) {
    target_clear_back(&film->target);
}

void film_reset(Film *film) {
    /* The next pass draws every pixel of the back, or it is copied from the front. */
    target_clear_front(&film->target);
    clear_light(film);
    film->samples = 0;
}

void film_begin(Film *film, const Program *program) {
    static const char *const names[] = {"film_sum",        "film_rest",       "film_scatter_sum",
                                        "film_search_sum", "film_chance_sum", "film_squares_sum",
                                        "film_rejects_sum"};
    target_begin(&film->target, program, names);
    program_set_uint(program, "film_zero", 0);
}

void film_give(const Film *film, const Program *program) {
    program_set_texture(program, "film_sum", film->target.textures[film->target.front][FILM_TEXTURE_SUM]);
    program_set_texture(program, "film_rest", film->target.textures[film->target.front][FILM_TEXTURE_REST]);
}

void film_keep(Film *film, const Rectangle *regions, int count) {
    target_keep(&film->target, regions, count);
}

void film_commit(Film *film, uint64_t samples) {
    target_swap(&film->target);
    film->samples += samples;
}

void film_add_light(Film *film, const float *points, int count, double paths) {
    film_light_add(film->light, points, count);
    film->light_paths += paths;
}

/* A float of the picture. */
static float to_float(double value) {
    return (float)fmax(fmin(value, (double)FLT_MAX), -(double)FLT_MAX);
}

double film_rejected_share(const FilmCount *count) {
    double samples = (double)count->accepted + (double)count->rejected, light = (double)count->light;
    return fmax(samples > 0 ? (double)count->rejected / samples : 0,
                light > 0 ? (double)count->light_rejected / light : 0);
}

/* Takes what the second sum adds to the means of a rectangle's pixels: 4 floats a pixel, 0 where there is no
 * second sum. */
static void take_light(const Film *film, const Rectangle *r, float *rgba) {
    bool any = film->light && film->light_paths > 0;
    for (int i = 0; i < r->width * r->height; i++, rgba += 4) {
        size_t pixel = (size_t)(r->y + i / r->width) * (size_t)film->width + (size_t)(r->x + i % r->width);
        for (int c = 0; c < 3; c++)
            rgba[c] = any ? film_light_mean(film->light->sum[4 * pixel + (size_t)c], film->light_scale,
                                            film->light_paths)
                          : 0;
        rgba[3] = 0;
    }
}

void film_read_light(const Film *film, float *rgba) {
    Rectangle all = {0, 0, film->width, film->height};
    take_light(film, &all, rgba);
}

GLuint film_join(const Film *film, const Program *program) {
    const GlApi *gl = film->target.gl;
    GLuint sum = film->target.textures[film->target.front][FILM_TEXTURE_SUM];
    if (!film->light || !(film->light_paths > 0)) return sum;
    program_use(program);
    program_set_texture(program, "join_sum", sum);
    program_set_texture(program, "join_light", film_light_texture(film->light, gl));
    program_set_float(program, "join_scale", film->light_scale / film->light_paths);
    gl->BindFramebuffer(GL_FRAMEBUFFER, film->joined_framebuffer);
    gl->Viewport(0, 0, film->width, film->height);
    program_draw(program, 0, 0, film->width, film->height);
    return film->joined;
}

/* Adds the second sum's light to an image of means. */
static void join_light(const Film *film, Image *image) {
    if (!film->light) return;
    size_t values = pixel_count(film) * 4;
    float *light = memory_get(values, sizeof *light);
    film_read_light(film, light);
    for (size_t i = 0; i < values; i++) {
        if (i % 4 != 3) image->rgba[i] = to_float((double)image->rgba[i] + (double)light[i]);
    }
    free(light);
}

bool film_read(const Film *film, Image *image, FilmCount *count, Error *error) {
    size_t pixels = pixel_count(film);
    float *rest = memory_get(pixels * 4, sizeof *rest);
    double accepted = 0, rejected = 0;
    *image = image_create(film->width, film->height);
    bool ok = target_read(&film->target, FILM_TEXTURE_SUM, image->rgba, error) &&
              target_read(&film->target, FILM_TEXTURE_REST, rest, error);
    for (size_t i = 0; ok && i < pixels; i++) {
        float *pixel = image->rgba + 4 * i;
        double weight = pixel[3];
        accepted += weight;
        rejected += rest[4 * i + 3];
        for (int c = 0; c < 3; c++)
            pixel[c] = film_mean((double)pixel[c] + (double)rest[4 * i + (size_t)c], weight);
        pixel[3] = weight > 0 ? 1.0f : 0.0f;
    }
    free(rest);
    if (ok) join_light(film, image);
    if (!ok) image_free(image);
    *count = (FilmCount){.accepted = (uint64_t)llround(accepted), .rejected = (uint64_t)llround(rejected)};
    if (film->light) {
        count->light_rejected = film->light->rejected;
        count->light = film->light->points;
    }
    return ok;
}

bool film_read_texture(const Film *film, int texture, float *rgba, Error *error) {
    return target_read(&film->target, texture, rgba, error);
}

bool film_read_samples(const Film *film, float *samples, Error *error) {
    size_t pixels = pixel_count(film);
    float *sum = memory_get(pixels * 4, sizeof *sum);
    bool ok = target_read(&film->target, FILM_TEXTURE_SUM, sum, error);
    for (size_t i = 0; ok && i < pixels; i++) samples[i] = sum[4 * i + 3];
    free(sum);
    return ok;
}

bool film_read_variance(const Film *film, float *rgb, Error *error) {
    size_t pixels = pixel_count(film);
    float *scatter = memory_get(pixels * 4, sizeof *scatter), *samples = memory_get(pixels, sizeof *samples);
    bool ok = film_read_samples(film, samples, error) &&
              target_read(&film->target, FILM_TEXTURE_SCATTER, scatter, error);
    for (size_t i = 0; ok && i < 3 * pixels; i++) {
        const float *pixel = scatter + i / 3 * 4;
        float groups = pixel[3];
        float variance = groups >= 2 ? pixel[i % 3] / (groups - 1) / samples[i / 3] : NAN;
        rgb[i] = isfinite(variance) ? variance : NAN;
    }
    free(scatter);
    free(samples);
    return ok;
}

bool film_read_search(const Film *film, FilmSearch *search, Error *error) {
    size_t pixels = pixel_count(film);
    double sums[4] = {0};
    *search = (FilmSearch){0};
    if (!(film->parts & FILM_SEARCH)) return true;
    float *counts = memory_get(pixels * 4, sizeof *counts);
    bool ok = target_read(&film->target, FILM_TEXTURE_SEARCH, counts, error);
    for (size_t i = 0; ok && i < 4 * pixels; i++) sums[i % 4] += (double)counts[i];
    free(counts);
    *search = (FilmSearch){sums[0], sums[1], sums[2], sums[3]};
    return ok;
}

bool film_read_chance(const Film *film, float *chance, float *squares, Error *error) {
    return target_read(&film->target, FILM_TEXTURE_CHANCE, chance, error) &&
           target_read(&film->target, FILM_TEXTURE_SQUARES, squares, error);
}

bool film_read_rejects(const Film *film, float *counts, Error *error) {
    memset(counts, 0, 4 * pixel_count(film) * sizeof *counts);
    return !(film->parts & FILM_REJECTS) || target_read(&film->target, FILM_TEXTURE_REJECTS, counts, error);
}

void film_read_points(const Film *film, float *counts) {
    for (size_t i = 0; i < pixel_count(film); i++)
        counts[i] = film->light ? (float)film->light->sum[4 * i + 3] : 0;
}

bool film_read_pixel(const Film *film, int x, int y, FilmPixel *pixel, Error *error) {
    float sum[4], rest[4], scatter[4], light[4];
    Rectangle place = {x, y, 1, 1};
    if (!target_read_pixel(&film->target, FILM_TEXTURE_SUM, x, y, sum, error) ||
        !target_read_pixel(&film->target, FILM_TEXTURE_REST, x, y, rest, error) ||
        !target_read_pixel(&film->target, FILM_TEXTURE_SCATTER, x, y, scatter, error)) {
        return false;
    }
    take_light(film, &place, light);
    double samples = (double)sum[3], groups = (double)scatter[3];
    *pixel = (FilmPixel){.samples = samples};
    for (int c = 0; c < 3; c++) {
        double mean = samples > 0 ? ((double)sum[c] + (double)rest[c]) / samples : 0;
        double variance = groups >= 2 ? (double)scatter[c] / (groups - 1) / samples : NAN;
        pixel->radiance[c] = mean + (double)light[c];
        pixel->variance[c] = isfinite(variance) ? variance : NAN;
    }
    return true;
}

bool film_archive(Film *film, Archive *archive, Error *error) {
    ARCHIVE(archive, film->samples);
    ARCHIVE(archive, film->light_paths);
    ARCHIVE(archive, film->light_scale);
    if (film->light) film_light_archive(film->light, archive);
    return target_archive(&film->target, archive, error);
}
