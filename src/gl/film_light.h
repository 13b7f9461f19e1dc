/* The second sum of a film: light that falls on any pixel, point by point (see gl/film.h). It is summed by
 * the host, because llvmpipe takes thirty times as long to draw a point as the processor takes to add it, and
 * a graphics processor traces paths so fast that reading their points back costs little beside. */
#pragma once

#include "base/archive.h"
#include "gl/gl_api.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct FilmLight {
    int width, height;
    /* 4 numbers a pixel, of which the last is the number of points that were left out. In double the sum of a
     * million points is exact to float's last digit, and does not depend on how the points were shared out
     * among parts of a picture (error/merge.h). */
    double *sum;
    /* The points that were added or left out, and of these those that were not finite, or would have made a
     * sum too large for a float. Points beside the picture do not count. */
    uint64_t points, rejected;
    /* The sum as a texture, and whether it has all that was added. */
    GLuint texture;
    bool current;
} FilmLight;

/* An empty sum. To be destroyed. */
FilmLight *film_light_create(const GlApi *gl, int width, int height);
void film_light_destroy(FilmLight *light, const GlApi *gl);
void film_light_clear(FilmLight *light);

/* Adds points of 4 floats in their order: the light, and its pixel as glsl/pass/light_point.glsl writes it.
 * Points beside the picture are left out, and so are those that are not finite or too large to be summed,
 * which are counted. */
void film_light_add(FilmLight *light, const float *points, int count);

/* Saves the sum, or loads it. */
void film_light_archive(FilmLight *light, Archive *archive);

/* The sum as a texture. */
GLuint film_light_texture(FilmLight *light, const GlApi *gl);
