/* The film: per pixel the sum of its samples, kept in float textures that a pass reads and writes in turn.
 *
 * Two RGBA32F textures a side. `sum`: radiance rgb and, in alpha, the samples taken in. `rest`: what each
 * addition to the sum rounded away (rgb), and the samples rejected because they were not finite (alpha). So a
 * mean keeps float's precision after any number of samples; a plain float sum stalls when a group falls below
 * its last bit.
 *
 * A pass's fragment shader includes pass/film.glsl and calls film_add() once a pixel. Row 0 is the picture's
 * top. */
#pragma once

#include "gl/program.h"
#include "image/image.h"

#include <stdint.h>

typedef struct Film {
    const GlApi *gl;
    int width, height;
    GLuint sum[2], rest[2], framebuffer[2];
    int front;        /* index of the side that holds the picture so far */
    uint64_t samples; /* a pixel, in committed passes */
} Film;

typedef struct FilmCount {
    uint64_t accepted, rejected; /* samples, over all pixels */
} FilmCount;

MUST_CHECK bool film_create(Film *film, const Context *context, int width, int height, Error *error);
void film_destroy(Film *film);

/* Forgets all samples. */
void film_reset(Film *film);

/* Starts a pass: binds the back side as target and the front side as the textures that pass/film.glsl reads.
 * The program must be in use. Any number of draws may follow, each on rows of its own. */
void film_begin(Film *film, const Program *program);

/* Ends a pass in which every pixel was drawn once: the back becomes the front. A pass that is begun and not
 * committed never was. */
void film_commit(Film *film, uint64_t samples);

/* The mean radiance, alpha 1 where a sample was accepted and 0 elsewhere, and the counts. */
MUST_CHECK bool film_read(const Film *film, Image *image, FilmCount *count, Error *error);
