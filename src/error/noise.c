#include "error/noise.h"

#include "base/memory.h"
#include "image/levels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The least and the largest q (noise.h). The largest is that of independent samples, and is used until q is
 * known. */
static const double least_fall = 0.25, independent_fall = 0.5;

/* The estimate is multiplied by this. The true errors of adaptive pictures were measured to be 0.85 to 1.09
 * times the estimate; the largest were those of pictures with specks that few samples find. With this factor
 * the true error is below the estimate in nine pictures of ten. In levels, which bend the radiance, they were
 * 0.6 to 1.15 times the estimate with 1.05. */
static const double certainty[NOISE_MEASURES] = {1.05, 1.1};

/* The estimate of an error that is spread over so many pixels as independent numbers errs by 0.7 / sqrt(of
 * them) of itself. Up to this much is within the certainty. */
static const double spread_error = 0.7, spread_within = 0.05;

/* What the worst tile may have for each level of the picture. */
static const double tile_share = 2;

static int count_tiles(const Noise *noise) {
    return noise->columns * noise->rows;
}

static int smaller(int a, int b) {
    return a < b ? a : b;
}

Noise noise_create(int width, int height, const ToneTable *tone) {
    Noise noise = {.width = width, .height = height, .counted = (long)width * height};
    size_t pixels = (size_t)width * (size_t)height;
    noise.columns = (width + NOISE_TILE - 1) / NOISE_TILE;
    noise.rows = (height + NOISE_TILE - 1) / NOISE_TILE;
    noise.tiles = memory_get((size_t)count_tiles(&noise), sizeof *noise.tiles);
    noise.before = memory_get(3 * pixels, sizeof *noise.before);
    noise.left_out = memory_get(pixels, 1);
    if (tone) {
        noise.tone = memory_get(1, sizeof *noise.tone);
        *noise.tone = *tone;
    }
    for (int i = 0; i < NOISE_MEASURES; i++)
        noise.figures[i] = (NoiseFigures){independent_fall, independent_fall, certainty[i]};
    for (int i = 0; i < count_tiles(&noise); i++) {
        int x = i % noise.columns * NOISE_TILE, y = i / noise.columns * NOISE_TILE;
        Rectangle r = {x, y, smaller(NOISE_TILE, width - x), smaller(NOISE_TILE, height - y)};
        noise.tiles[i] = (NoiseTile){.pixels = r, .counted = r.width * r.height};
    }
    return noise;
}

void noise_destroy(Noise *noise) {
    free(noise->tiles);
    free(noise->before);
    free(noise->left_out);
    free(noise->tone);
    *noise = (Noise){0};
}

static size_t pixel_of(const Noise *noise, const Rectangle *r, int k) {
    return (size_t)(r->y + k / r->width) * (size_t)noise->width + (size_t)(r->x + k % r->width);
}

void noise_leave_out(Noise *noise, const unsigned char *mask) {
    size_t pixels = (size_t)noise->width * (size_t)noise->height;
    long counted = 0;
    for (size_t i = 0; i < pixels; i++) counted += !(mask[i] || noise->left_out[i]);
    if (!counted) return;
    noise->counted = counted;
    for (size_t i = 0; i < pixels; i++) noise->left_out[i] |= mask[i] != 0;
    for (int i = 0; i < count_tiles(noise); i++) {
        const Rectangle *r = &noise->tiles[i].pixels;
        int here = 0;
        for (int k = 0; k < r->width * r->height; k++) here += !noise->left_out[pixel_of(noise, r, k)];
        noise->tiles[i].counted = here;
    }
}

void noise_show(Noise *noise, double gain) {
    if (!noise->tone || noise->tone->gain == (float)gain) return;
    noise->tone->gain = (float)gain;
    for (int i = 0; i < count_tiles(noise); i++)
        if (noise->tiles[i].times) noise->tiles[i].change[NOISE_LEVELS].now = INFINITY;
}

static bool measures(const Noise *noise, NoiseMeasure measure) {
    return measure == NOISE_RADIANCE || noise->tone;
}

static void add_change(NoiseChange *change, double square) {
    change->now += square;
    change->squares += square * square;
}

/* Radiances may be so large that their squares are too large for a float. */
static double radiance_change(const float *now, const float *before) {
    float sum = 0;
    double large = 0;
    for (int c = 0; c < 3; c++) {
        float difference = now[c] - before[c];
        sum += difference * difference;
    }
    if (sum < INFINITY) return (double)(sum / 3);
    for (int c = 0; c < 3; c++) large += pow((double)now[c] - (double)before[c], 2) / 3;
    return large;
}

static double levels_change(const ToneTable *tone, const float *now, const float *before) {
    float sum = 0;
    for (int c = 0; c < 3; c++) {
        float difference = tone_table_level(tone, now[c]) - tone_table_level(tone, before[c]);
        sum += difference * difference;
    }
    return (double)(sum / 3);
}

static void measure_row(Noise *noise, NoiseTile *tile, const Image *mean, int y) {
    size_t first = (size_t)y * (size_t)noise->width + (size_t)tile->pixels.x;
    for (size_t pixel = first; pixel < first + (size_t)tile->pixels.width; pixel++) {
        const float *now = mean->rgba + 4 * pixel;
        float *before = noise->before + 3 * pixel;
        if (!noise->left_out[pixel]) {
            add_change(&tile->change[NOISE_RADIANCE], radiance_change(now, before));
            if (noise->tone) add_change(&tile->change[NOISE_LEVELS], levels_change(noise->tone, now, before));
        }
        for (int c = 0; c < 3; c++) before[c] = now[c];
    }
}

/* Notes how much the pixels of a tile have changed, and keeps the mean for the next comparison. */
static void measure_tile(Noise *noise, NoiseTile *tile, const Image *mean) {
    const Rectangle *r = &tile->pixels;
    for (int i = 0; i < NOISE_MEASURES; i++) {
        NoiseChange *change = &tile->change[i];
        *change = (NoiseChange){.earlier = change->now, .unmet = change->unmet};
    }
    for (int y = r->y; y < r->y + r->height; y++) measure_row(noise, tile, mean, y);
    tile->measured = tile->samples;
    tile->times++;
}

/* Returns the factor that is left of a change after `levels` more doublings. */
static double fallen(const NoiseFigures *figures, double levels) {
    return pow(figures->fall, levels);
}

/* Measures q from all tiles for which two changes are known. */
static void measure_fall(Noise *noise, NoiseMeasure measure) {
    NoiseFigures *figures = &noise->figures[measure];
    double now = 0, earlier = 0;
    for (int i = 0; i < count_tiles(noise); i++) {
        if (noise->tiles[i].times < 3) continue;
        now += noise->tiles[i].change[measure].now;
        earlier += noise->tiles[i].change[measure].earlier;
    }
    if (!(earlier > 0 && earlier < INFINITY)) return;
    figures->measured_fall = fmin(fmax(now / earlier, least_fall), independent_fall);
    figures->fall = 0.5 * (independent_fall + figures->measured_fall);
}

/* The factor for an estimate from pixels whose squared changes and their squares have these sums. */
static double caution_of(NoiseMeasure measure, double changes, double squares) {
    if (!(squares > 0)) return certainty[measure];
    double pixels = changes * changes / squares;
    return certainty[measure] * (1 + fmax(spread_error / sqrt(pixels) - spread_within, 0));
}

/* The changes of tiles with different numbers of samples are scaled to variances, up to a factor. */
static void measure_caution(Noise *noise, NoiseMeasure measure) {
    NoiseFigures *figures = &noise->figures[measure];
    double changes = 0, squares = 0;
    for (int i = 0; i < count_tiles(noise); i++) {
        const NoiseTile *tile = &noise->tiles[i];
        if (tile->times < 2) continue;
        double scale = fallen(figures, log2((double)tile->samples / (double)tile->measured));
        changes += scale * tile->change[measure].now;
        squares += scale * scale * tile->change[measure].squares;
    }
    figures->caution = caution_of(measure, changes, squares);
}

static void measure_mean(Noise *noise, const Image *mean) {
    size_t pixels = (size_t)noise->width * (size_t)noise->height;
    double sum = 0;
    float largest = 0;
    for (size_t i = 0; i < pixels; i++) {
        const float *rgb = mean->rgba + 4 * i;
        if (noise->left_out[i]) continue;
        for (int c = 0; c < 3; c++) {
            sum += (double)rgb[c];
            largest = rgb[c] > largest ? rgb[c] : largest;
        }
    }
    noise->largest = largest;
    noise->mean = fmax(sum / (double)(noise->counted * 3), NOISE_LEAST_MEAN);
}

void noise_measure(Noise *noise, const Image *mean) {
    for (int i = 0; i < count_tiles(noise); i++) {
        NoiseTile *tile = &noise->tiles[i];
        if (tile->samples < 2 * tile->measured || tile->samples == 0) continue;
        measure_tile(noise, tile, mean);
    }
    for (NoiseMeasure i = 0; i < NOISE_MEASURES; i++) {
        if (!measures(noise, i)) continue;
        measure_fall(noise, i);
        measure_caution(noise, i);
    }
    measure_mean(noise, mean);
}

double noise_of_tile(const Noise *noise, const NoiseTile *tile, NoiseMeasure measure, double samples) {
    const NoiseFigures *figures = &noise->figures[measure];
    if (tile->times < 2 || !measures(noise, measure)) return INFINITY;
    double levels = log2(samples / (double)tile->measured), change = tile->change[measure].now;
    /* The change before, multiplied by q, estimates the same value. The mean of both has less noise of its
     * own, and so fewer tiles seem to be done too early. */
    if (tile->times > 2) change = 0.5 * (change + figures->measured_fall * tile->change[measure].earlier);
    return change * figures->fall / (1 - figures->fall) * fallen(figures, levels) +
           tile->change[measure].unmet / samples;
}

static double whole_error(const Noise *noise, NoiseMeasure measure) {
    double sum = 0;
    for (int i = 0; i < count_tiles(noise); i++)
        sum += noise_of_tile(noise, &noise->tiles[i], measure, (double)noise->tiles[i].samples);
    return sum;
}

static double tile_caution(const NoiseTile *tile) {
    const NoiseChange *change = &tile->change[NOISE_LEVELS];
    return caution_of(NOISE_LEVELS, change->now, change->squares);
}

void noise_levels(const Noise *noise, double *rms, double *worst_tile) {
    double sum = whole_error(noise, NOISE_LEVELS), worst = -1;
    *rms = *worst_tile = INFINITY;
    if (!(sum < INFINITY)) return;
    *rms = noise->figures[NOISE_LEVELS].caution * sqrt(sum / (double)noise->counted);
    for (int i = 0; i < count_tiles(noise); i++) {
        const NoiseTile *tile = &noise->tiles[i];
        if (tile->counted < LEVELS_TILE_LEAST) continue;
        double error = noise_of_tile(noise, tile, NOISE_LEVELS, (double)tile->samples);
        worst = fmax(worst, tile_caution(tile) * sqrt(error / tile->counted));
    }
    *worst_tile = worst < 0 ? *rms : worst;
}

double noise_error(const Noise *noise, NoiseMeasure measure) {
    if (measure == NOISE_LEVELS) {
        double rms, worst;
        noise_levels(noise, &rms, &worst);
        return fmax(rms, worst / tile_share);
    }
    double sum = whole_error(noise, measure);
    if (!(sum < INFINITY)) return INFINITY;
    return sum > 0 ? noise->figures[measure].caution * 100 * sqrt(sum / (double)noise->counted) / noise->mean
                   : 0;
}

double noise_goal(const Noise *noise, NoiseMeasure measure, double error) {
    double unit = measure == NOISE_RADIANCE ? noise->mean : 1;
    if (measure == NOISE_RADIANCE) error *= 0.01;
    return pow(error / noise->figures[measure].caution * unit, 2) * (double)noise->counted;
}

double noise_tile_goal(const NoiseTile *tile, NoiseMeasure measure, double error) {
    if (measure == NOISE_RADIANCE || tile->counted < LEVELS_TILE_LEAST) return INFINITY;
    return pow(tile_share * error / tile_caution(tile), 2) * tile->counted;
}

static void calibrate_tile(const Noise *noise, const NoiseTile *tile, float *variance) {
    const Rectangle *r = &tile->pixels;
    double sum = 0, error = noise_of_tile(noise, tile, NOISE_RADIANCE, (double)tile->samples);
    for (int pass = 0; pass < 2; pass++) {
        for (int k = 0; k < 3 * r->width * r->height; k++) {
            size_t pixel = pixel_of(noise, r, k / 3);
            float *value = &variance[3 * pixel + (size_t)(k % 3)];
            if (noise->left_out[pixel]) continue;
            if (pass == 0) sum += (double)*value / 3;
            if (pass == 1 && sum > 0 && error < INFINITY) *value = (float)(*value * error / sum);
        }
    }
}

void noise_calibrate(const Noise *noise, float *variance) {
    for (int i = 0; i < count_tiles(noise); i++) calibrate_tile(noise, &noise->tiles[i], variance);
}
