/* The film holds, for each pixel, the sum of its samples. The sums are float textures on two sides: a pass
 * reads one side and writes the other.
 *
 * Each side has two RGBA32F textures. `sum` holds the radiance (rgb) and the number of accepted samples
 * (alpha). `rest` holds what each addition to the sum rounded away (rgb) and the number of samples that were
 * rejected because they were not finite (alpha). With it a mean keeps float's precision after any number of
 * samples; a plain float sum stalls when a group of samples falls below its last bit.
 *
 * With FILM_SCATTER there is a third texture, `scatter`, from which the error is estimated: the sum of n_g
 * (m_g - m)^2 over groups of n_g samples with means m_g, where m is the mean of all (rgb), and the number of
 * groups (alpha). Divided by groups - 1 it estimates the variance of a sample, whatever the sizes of the
 * groups; divided by the number of samples too, the variance of the mean. Both hold for independent samples
 * (--sequence random). The groups of a low-discrepancy sequence fill each other's gaps, so the mean is better
 * than the scatter of its groups: there the estimate is an upper one.
 *
 * With FILM_SEARCH, for scenes whose rays search by steps (march()), there is a fourth, `search`: the number
 * of rays that searched, of their steps, of rays that met a field that is no distance, and of rays that took
 * all the steps that they may.
 *
 * With FILM_CHANCE there are a fifth and a sixth, for pictures in which some sunlight is left to chance: no
 * method samples it, so a path finds it only by luck. `chance` holds the number of paths to which that
 * happened, the luminance that they are expected to bring from the sun, the luminance that they did bring,
 * and a bit for each material that threw some of it. Bit FILM_CHANCE_IMAGE is set if the sun itself was seen
 * in mirrors or glass. `squares` holds the expected square of the radiance that chance brings in one sample,
 * averaged over the channels and summed over the samples, in rgb by a material's number modulo 3; and in
 * alpha a bit for each material whose light was found (glsl/sun/count.glsl).
 *
 * With FILM_REJECTS there is a seventh, `rejects`: the number of samples that were left out because they were
 * not finite, because their group would have made the sum too large for a float, and because the driver had
 * ended their loops; and the number of those that were added although they were negative somewhere.
 *
 * With FILM_LIGHT there is a second sum, `light`, for light that is traced from the lights to the camera, or
 * that Markov chains bring. Such light falls on any pixel and is added point by point. It belongs to the
 * picture as a whole: the mean of a pixel is sum / samples + scale * light / light paths.
 *
 * The fragment shader of a pass includes pass/film.glsl and calls film_add() once a pixel. Before it, it
 * calls film_scatter() of pass/scatter.glsl, film_search() of pass/search.glsl and film_chance() of
 * pass/chance.glsl, or the functions of the same name in the files NAME_none.glsl. Row 0 is the picture's
 * top. */
#pragma once

#include "gl/film_light.h"
#include "gl/target.h"
#include "image/image.h"

#include <stdint.h>

/* The textures of a film, by their names above. */
enum {
    FILM_TEXTURE_SUM,
    FILM_TEXTURE_REST,
    FILM_TEXTURE_SCATTER,
    FILM_TEXTURE_SEARCH,
    FILM_TEXTURE_CHANCE,
    FILM_TEXTURE_SQUARES,
    FILM_TEXTURE_REJECTS
};

enum { FILM_SCATTER = 1, FILM_SEARCH = 2, FILM_LIGHT = 4, FILM_CHANCE = 8, FILM_REJECTS = 16 };

typedef struct Film {
    int width, height;
    /* FILM_SCATTER and the like: what it has beside sum and rest. */
    unsigned parts;
    /* Its textures are sum, rest, scatter, search, chance, squares and rejects. */
    Target target;
    /* Samples of each pixel, of the committed passes that drew all pixels. */
    uint64_t samples;
    /* The second sum; NULL without FILM_LIGHT. */
    FilmLight *light;
    /* What film_join() draws into, and its framebuffer. */
    GLuint joined, joined_framebuffer;
    /* The number of light paths in the second sum, including those that reached no pixel. */
    double light_paths;
    /* The radiance of a pixel for light / light_paths = 1. It is 1 unless the film's user sets another. */
    double light_scale;
    /* The bytes that were taken beside those of the target (base/budget.h). */
    size_t memory;
} Film;

/* The mean of samples whose sum is known; 0 of none. */
static inline float film_mean(double sum, double samples) {
    return samples > 0 ? (float)(sum / samples) : 0.0f;
}

/* What light paths add to the mean of a pixel. */
static inline float film_light_mean(double sum, double scale, double paths) {
    return (float)(sum * scale / paths);
}

typedef struct FilmCount {
    /* Numbers of samples, over all pixels. */
    uint64_t accepted, rejected;
    /* Points of light that the second sum left out, and those that were added to it or left out. */
    uint64_t light_rejected, light;
} FilmCount;

/* The share of the samples and of the points of light that were left out: the larger of the two. */
double film_rejected_share(const FilmCount *count);

/* Counts over all pixels and samples. Counts above 2^24 in a pixel are rounded. */
typedef struct FilmSearch {
    double rays, steps, broken, cut;
} FilmSearch;

/* Materials that `chance` and `squares` tell apart, by bits; the last one stands for all others. The bit
 * above is that of the sun's own image. */
enum { FILM_CHANCE_MATERIALS = 20, FILM_CHANCE_IMAGE = 20 };

/* Creates an empty film. `parts`: FILM_SCATTER is needed for film_read_variance(), FILM_SEARCH for
 * film_read_search(), FILM_LIGHT for film_add_light(), FILM_CHANCE for film_read_chance(). */
MUST_CHECK bool film_create(Film *film, const Context *context, int width, int height, unsigned parts,
                            Error *error);
void film_destroy(Film *film);

/* Removes all samples. */
void film_reset(Film *film);

/* Empties what the next pass draws into. It matters if not all of it is drawn. */
void film_clear_next(Film *film);

/* Starts a pass: the back side is drawn into, and pass/film.glsl reads the front side's textures. The program
 * must be in use. Any number of draws may follow, each on rows of its own. */
void film_begin(Film *film, const Program *program);

/* Gives a program the textures that pass/film_samples.glsl reads. */
void film_give(const Film *film, const Program *program);

/* Call this before a pass that does not draw every pixel. It copies `regions` from the front to the back, so
 * that pixels which the pass skips keep their value. Before the first such pass the regions are the whole
 * picture; later, those that the pass before drew and this one will not. */
void film_keep(Film *film, const Rectangle *regions, int count);

/* Ends a pass in which every pixel was drawn once or kept: the back becomes the front, and `samples` is added
 * to film->samples. If a pass is begun but not committed, the film is unchanged. */
void film_commit(Film *film, uint64_t samples);

/* Adds points of light to the second sum, 4 floats each, as film_light_add() does. `paths` is the number of
 * light paths that they stand for. */
void film_add_light(Film *film, const float *points, int count, double paths);

/* Returns a texture of sums that have the second sum's part of the mean in them: radiance in rgb, samples in
 * alpha. It is the film's own sum where there is no second sum, or else drawn by `program`, which is that of
 * pass/join.glsl. */
GLuint film_join(const Film *film, const Program *program);

/* Reads the second sum's part of the mean: 4 floats a pixel, of which the last has no meaning. It is 0 where
 * there is no second sum. */
void film_read_light(const Film *film, float *rgba);

/* Reads the mean radiance, including the second sum. It is finite: what both sums together have beyond a
 * float is cut off. Alpha is 1 where a sample was accepted and 0 elsewhere. On success the caller frees the
 * image. */
MUST_CHECK bool film_read(const Film *film, Image *image, FilmCount *count, Error *error);

/* Reads one of the textures: 4 floats a pixel. The film must have it. */
MUST_CHECK bool film_read_texture(const Film *film, int texture, float *rgba, Error *error);

/* Reads the number of accepted samples: one float a pixel. */
MUST_CHECK bool film_read_samples(const Film *film, float *samples, Error *error);

/* Reads the estimated variance of each pixel's mean, without that of the second sum: 3 floats a pixel, NaN
 * where fewer than two groups were taken, and where it is too large for a float. The film must have
 * FILM_SCATTER. */
MUST_CHECK bool film_read_variance(const Film *film, float *rgb, Error *error);

/* Saves the film, or loads it into a film of the same size and parts. */
MUST_CHECK bool film_archive(Film *film, Archive *archive, Error *error);

/* All counts are 0 for a film without FILM_SEARCH. */
MUST_CHECK bool film_read_search(const Film *film, FilmSearch *search, Error *error);

/* Reads the textures `chance` and `squares`: 4 floats a pixel each. The film must have FILM_CHANCE. */
MUST_CHECK bool film_read_chance(const Film *film, float *chance, float *squares, Error *error);

/* Reads the texture `rejects`: 4 floats a pixel. Without FILM_REJECTS all are 0. */
MUST_CHECK bool film_read_rejects(const Film *film, float *counts, Error *error);

/* Reads the number of points of light that the second sum left out: one float a pixel. */
void film_read_points(const Film *film, float *counts);

/* One pixel of a film with FILM_SCATTER. */
typedef struct FilmPixel {
    /* The mean, including the second sum. */
    double radiance[3];
    /* The number of accepted samples. */
    double samples;
    /* The estimated variance of the mean, as in film_read_variance(): without that of the second sum. */
    double variance[3];
} FilmPixel;

MUST_CHECK bool film_read_pixel(const Film *film, int x, int y, FilmPixel *pixel, Error *error);
