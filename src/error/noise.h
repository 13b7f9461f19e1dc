/* Estimates the noise that is left in the mean of a film, for each tile of pixels and for the whole picture.
 *
 * The mean M_n of n samples is compared with the mean M_n/2 of the first half of them. Let V(n) be the
 * variance of M_n. If samples are independent, the expectation of (M_n - M_n/2)^2 is V(n/2) - V(n), which
 * equals V(n).
 *
 * Points of a low-discrepancy sequence are not independent. With each doubling, V is multiplied by a factor q
 * that is below 1/2. The two halves of a sequence scrambled as Owen does are statistically alike, so
 * E (M_n - M_n/2)^2 = V(n/2) - V(n) holds for each doubling. V(n) is then the sum of the changes that all
 * doublings still to come will make: change * q / (1 - q).
 *
 * q is measured over the whole picture, from the last two changes. It is 0.38 to 0.46 for sobol and 0.5 for
 * random. The estimate uses the mean of the measured q and 1/2, which makes it a few percent too large.
 *
 * Tiles may have different numbers of samples. A tile is measured only when its number of samples has
 * doubled. Between measurements V ~ 1/n is assumed.
 *
 * A film's second sum, of light that is traced from the lights, has noise of its own. All tiles have the same
 * number of light paths, and the change of that sum is measured whenever this number has doubled. Light paths
 * count as independent.
 *
 * All of it is done in one measure or in two: of the radiance, and of the picture as it is shown. */
#pragma once

#include <stdint.h>

#include "base/archive.h"
#include "gl/camera.h"
#include "image/image.h"
#include "image/tone_table.h"

/* Width and height of a tile, in pixels. */
enum { NOISE_TILE = 16 };

typedef enum NoiseMeasure {
    /* Of the radiance; the picture's figure is relRMSE in percent, as image/compare.h defines it. */
    NOISE_RADIANCE,
    /* Of the picture as it is shown, in 8-bit levels; the picture's figure is the RMS, or half of the worst
     * tile's RMS if that is more (image/levels.h). */
    NOISE_LEVELS,
    NOISE_MEASURES
} NoiseMeasure;

/* How the pixels of a tile have changed, in one measure. The squared change of a pixel is averaged over the
 * channels. */
typedef struct NoiseChange {
    /* The sum over the pixels by the last doubling. Known after 2 measurements. */
    double now;
    /* The same by the doubling before that one. Known after 3 measurements. */
    double earlier;
    /* The sum of the squares of the terms of `now`. */
    double squares;
    /* The expected squared error, times the samples of each pixel, of light that no sample has found yet. It
     * is 0 unless the caller sets it. */
    double unmet;
} NoiseChange;

/* What noise is measured of. */
typedef struct NoisePicture {
    /* The film's picture (film_read()). */
    const Image *mean;
    /* The part of it that light paths brought, 4 floats a pixel (film_read_light()), and their number; NULL
     * and 0 where there are none. */
    const float *light;
    double light_paths;
} NoisePicture;

/* The state of the second sum's measurements. */
typedef struct NoiseLight {
    /* Light paths now, and when the sum was last measured. */
    double paths, measured;
    /* How often it was measured. */
    int times;
    /* 3 numbers for each pixel: the sum that the next one is compared with. NULL without light paths. */
    float *before;
} NoiseLight;

typedef struct NoiseTile {
    Rectangle pixels;
    /* How many of them are not left out. */
    int counted;
    /* Samples of each pixel, now. */
    uint64_t samples;
    /* Samples of each pixel when the tile was last measured. */
    uint64_t measured;
    /* How often the tile was measured. */
    int times;
    NoiseChange change[NOISE_MEASURES];
    /* How the light of light paths has changed. Only `now` and `squares` are used. */
    NoiseChange light[NOISE_MEASURES];
} NoiseTile;

/* The state of one measure. */
typedef struct NoiseFigures {
    /* The q that the estimate uses. */
    double fall;
    double measured_fall;
    /* The picture's figure is multiplied by this. */
    double caution;
} NoiseFigures;

typedef struct Noise {
    int width, height, columns, rows;
    /* The part of the picture that is rendered. All pixels outside of it are left out. */
    Rectangle area;
    /* columns * rows tiles, row by row: the cells of a grid over the picture, where they reach into the area.
     */
    NoiseTile *tiles;
    /* 3 numbers for each pixel: the mean, without the light of light paths, that the next mean is compared
     * with. */
    float *before;
    NoiseLight light;
    /* 1 for each pixel that all figures and the mean leave out: those of the sun's own image, and those
     * outside of the area. */
    unsigned char *left_out;
    long counted;
    /* How the picture is shown; NULL if levels are not measured. */
    ToneTable *tone;
    NoiseFigures figures[NOISE_MEASURES];
    /* The picture's mean over pixels and channels, at least NOISE_LEAST_MEAN. */
    double mean;
    /* The largest mean of a pixel's channel. */
    float largest;
} Noise;

/* A darker picture is judged as if it had this mean. Otherwise a picture of next to nothing, such as that of
 * a closed box that leaks, would never be good enough. Starlight on the ground is a hundred times as much. */
#define NOISE_LEAST_MEAN 1e-9

/* `tone` is NULL if levels need not be measured. */
Noise noise_create(int width, int height, const ToneTable *tone);

/* The same for a picture of which only an area is rendered. */
Noise noise_create_area(int width, int height, Rectangle area, const ToneTable *tone);
void noise_destroy(Noise *noise);

/* Leaves out the pixels in which `mask` is not 0, from the next measurement on and besides those that are
 * left out already. If that would be all pixels, none is left out. */
void noise_leave_out(Noise *noise, const unsigned char *mask);

/* Notes that the picture is now shown with another gain. Its error in levels is not known again before the
 * second measurement after that. */
void noise_show(Noise *noise, double gain);

/* Compares the picture with the picture before. The caller has set `tiles[i].samples` to the samples in
 * it. Tiles whose samples have doubled since their last measurement are measured; the others wait. */
void noise_measure(Noise *noise, const NoisePicture *picture);

/* These are for noise_figures.c too. The index of a tile's pixel k: */
size_t noise_pixel(const Noise *noise, const Rectangle *tile, int k);

/* Whether the measure is measured. */
bool noise_measures(const Noise *noise, NoiseMeasure measure);

/* The factor that is left of a change after `levels` more doublings. */
double noise_fallen(const NoiseFigures *figures, double levels);

/* The factor for an estimate from pixels whose squared changes and their squares have these sums. */
double noise_caution(NoiseMeasure measure, double changes, double squares);

static inline int noise_tile_count(const Noise *noise) {
    return noise->columns * noise->rows;
}
