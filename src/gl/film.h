/* The film: per pixel the sum of its samples, kept in float textures that a pass reads and writes in turn.
 *
 * Two RGBA32F textures a side. `sum`: radiance rgb and, in alpha, the samples taken in. `rest`: what each
 * addition to the sum rounded away (rgb), and the samples rejected because they were not finite (alpha). So a
 * mean keeps float's precision after any number of samples; a plain float sum stalls when a group falls below
 * its last bit.
 *
 * A film that is to know its error has a third, `scatter`: how the groups' means scatter about the mean, sum
 * of n_g (m_g - m)^2 over groups of n_g samples and mean m_g (rgb), and the number of groups (alpha). Over
 * groups - 1 it estimates a sample's variance, whatever their sizes; over samples more, the mean's. So it is
 * where samples are independent (--sequence random). The groups of one low-discrepancy sequence fill each
 * other's gaps, which makes the mean better than its groups' scatter tells: there it is an upper estimate.
 *
 * A film of a scene that searches (march()) has a fourth, `search`: rays that searched, their steps, those
 * that met a field that is no distance, and those that took all the steps they may.
 *
 * A film of a picture in which some sunlight is left to chance has a fifth, `chance`: paths whose sunlight
 * was left to chance, the luminance that they are expected to bring from the sun, the luminance that they did
 * bring, and a bit for each material that threw some of it (glsl/sun/count.glsl).
 *
 * A film of a scene whose light is traced from the lights to the camera too has a second sum, `splat`: that
 * light falls on any pixel, and is added there point by point (rgb; alpha counts the points). It belongs to
 * the picture as a whole: the mean of a pixel is sum / samples + scale * splat / light paths. The second sum
 * is a plain float sum, which loses less than 1e-4 of itself up to a million points a pixel.
 *
 * A pass's fragment shader includes pass/film.glsl and calls film_add() once a pixel, and before it
 * film_scatter() of pass/scatter.glsl, film_search() of pass/search.glsl and film_chance() of
 * pass/chance.glsl, or of the files NAME_none.glsl. Row 0 is the picture's top. */
#pragma once

#include "gl/target.h"
#include "image/image.h"

#include <stdint.h>

enum { FILM_SCATTER = 1, FILM_SEARCH = 2, FILM_SPLAT = 4, FILM_CHANCE = 8 };

typedef struct Film {
    int width, height;
    unsigned parts;   /* beside sum and rest */
    Target target;    /* textures: sum, rest, scatter, search, chance */
    uint64_t samples; /* a pixel, in committed passes over all pixels */
    /* The second sum; 0 where there is none. */
    GLuint splat, splat_framebuffer;
    /* Paths whose light the second sum holds, counting those that reached no pixel. */
    double light_paths;
    /* The radiance of a pixel for splat / light_paths = 1; 1 unless the user of the film sets another. */
    double splat_scale;
} Film;

typedef struct FilmCount {
    uint64_t accepted, rejected; /* samples, over all pixels */
} FilmCount;

/* Over all pixels and samples; what was counted beyond 2^24 a pixel is rounded. */
typedef struct FilmSearch {
    double rays, steps, broken, cut;
} FilmSearch;

/* What a picture leaves to chance: shares of its paths, of its pixels and of its light, 0 to 1, and a bit for
 * each material that throws a hundredth of that light or more. The share of the light is what the expected
 * light is of the picture's, whether the picture has found it yet or not. */
typedef struct FilmChance {
    double paths, pixels, light;
    unsigned materials;
} FilmChance;

/* `parts`: of FILM_SCATTER, for film_read_variance(); FILM_SEARCH, for film_read_search(); FILM_SPLAT, for
 * film_splat_begin(); FILM_CHANCE, for film_read_chance(). */
MUST_CHECK bool film_create(Film *film, const Context *context, int width, int height, unsigned parts,
                            Error *error);
void film_destroy(Film *film);

/* Forgets all samples. */
void film_reset(Film *film);

/* Starts a pass: binds the back side as target and the front side as the textures that pass/film.glsl reads.
 * The program must be in use. Any number of draws may follow, each on rows of its own. */
void film_begin(Film *film, const Program *program);

/* Copies these regions from the front to the back, so that passes that leave them out leave them as they are:
 * for the first such pass all of the picture, and from then on what each drew and the next will not. */
void film_keep(Film *film, const Rectangle *regions, int count);

/* Ends a pass in which every pixel was drawn once: the back becomes the front. A pass that is begun and not
 * committed never was. */
void film_commit(Film *film, uint64_t samples);

/* Between these two, points are added to the second sum: program_draw_points() with a program of
 * program_create_points(), which is in use and told `splat_size` by film_splat_begin(). `paths` is how many
 * light paths the points stand for. A draw that was left out costs nothing but its paths. */
void film_splat_begin(const Film *film, const Program *program);
void film_splat_end(Film *film, double paths);

/* The mean radiance, with the second sum's, alpha 1 where a sample was accepted and 0 elsewhere, and the
 * counts. */
MUST_CHECK bool film_read(const Film *film, Image *image, FilmCount *count, Error *error);

/* Accepted samples: one float a pixel. */
MUST_CHECK bool film_read_samples(const Film *film, float *samples, Error *error);

/* The estimated variance of each pixel's mean: 3 floats a pixel, NaN where fewer than two groups were taken
 * and it is not known. Of a film with `scatter`. */
MUST_CHECK bool film_read_variance(const Film *film, float *rgb, Error *error);

/* All zero for a film without `search`. */
MUST_CHECK bool film_read_search(const Film *film, FilmSearch *search, Error *error);

/* All zero for a film without `chance`. */
MUST_CHECK bool film_read_chance(const Film *film, FilmChance *chance, Error *error);

/* What a film with `scatter` knows of one pixel. */
typedef struct FilmPixel {
    double radiance[3]; /* the mean, with the second sum's */
    double samples;     /* accepted */
    double variance[3]; /* of the mean, as film_read_variance() has it */
} FilmPixel;

MUST_CHECK bool film_read_pixel(const Film *film, int x, int y, FilmPixel *pixel, Error *error);
