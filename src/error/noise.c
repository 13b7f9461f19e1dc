#include "error/noise.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The least and the largest q (noise.h). The largest is that of independent samples, and is used until q is
 * known. */
static const double least_fall = 0.25, independent_fall = 0.5;

/* The estimate is multiplied by this. The true errors of adaptive pictures were measured to be 0.85 to 1.09
 * times the estimate; the largest were those of pictures with specks that few samples find. With this factor
 * the true error is below the estimate in nine pictures of ten. */
static const double certainty = 1.05;

static int count_tiles(const Noise *noise) {
    return noise->columns * noise->rows;
}

static int smaller(int a, int b) {
    return a < b ? a : b;
}

Noise noise_create(int width, int height, double trim) {
    Noise noise = {.width = width,
                   .height = height,
                   .trim = trim,
                   .worst = INFINITY,
                   .fall = independent_fall,
                   .measured_fall = independent_fall};
    size_t pixels = (size_t)width * (size_t)height;
    noise.columns = (width + NOISE_TILE - 1) / NOISE_TILE;
    noise.rows = (height + NOISE_TILE - 1) / NOISE_TILE;
    noise.tiles = memory_get((size_t)count_tiles(&noise), sizeof *noise.tiles);
    noise.before = memory_get(3 * pixels, sizeof *noise.before);
    noise.change = memory_get(pixels, sizeof *noise.change);
    for (int i = 0; i < count_tiles(&noise); i++) {
        int x = i % noise.columns * NOISE_TILE, y = i / noise.columns * NOISE_TILE;
        noise.tiles[i] =
            (NoiseTile){.pixels = {x, y, smaller(NOISE_TILE, width - x), smaller(NOISE_TILE, height - y)}};
    }
    return noise;
}

void noise_destroy(Noise *noise) {
    free(noise->tiles);
    free(noise->before);
    free(noise->change);
    *noise = (Noise){0};
}

/* Notes how much the pixels of a tile have changed, and keeps the mean for the next comparison. */
static void measure_pixels(Noise *noise, const NoiseTile *tile, const Image *mean) {
    const Rectangle *r = &tile->pixels;
    for (int y = r->y; y < r->y + r->height; y++) {
        for (int x = r->x; x < r->x + r->width; x++) {
            size_t pixel = (size_t)y * (size_t)noise->width + (size_t)x;
            float sum = 0;
            for (size_t c = 0; c < 3; c++) {
                float now = mean->rgba[4 * pixel + c], difference = now - noise->before[3 * pixel + c];
                sum += difference * difference;
                noise->before[3 * pixel + c] = now;
            }
            noise->change[pixel] = sum / 3;
        }
    }
}

/* Returns the factor that is left of a change after `levels` more doublings. */
static double fallen(const Noise *noise, double levels) {
    return pow(noise->fall, levels);
}

/* Returns the factor that turns the changes of a tile's pixels into their variances, up to a factor that is
 * the same for all tiles. Pixels of tiles with different numbers of samples can then be compared. */
static float pixel_scale(const Noise *noise, const NoiseTile *tile) {
    return (float)fallen(noise, log2((double)tile->samples / (double)tile->measured));
}

static int by_size(const void *a, const void *b) {
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* Finds the squared change at which the worst pixels begin. */
static void find_worst(Noise *noise) {
    size_t pixels = (size_t)noise->width * (size_t)noise->height;
    size_t left_out = (size_t)(noise->trim * (double)pixels), n = 0;
    noise->worst = INFINITY;
    if (!left_out) return;
    float *errors = memory_get(pixels, sizeof *errors);
    for (int i = 0; i < count_tiles(noise); i++) {
        const NoiseTile *tile = &noise->tiles[i];
        const Rectangle *r = &tile->pixels;
        float scale = tile->times > 1 ? pixel_scale(noise, tile) : 0;
        for (int k = 0; k < r->width * r->height; k++) {
            size_t pixel =
                (size_t)(r->y + k / r->width) * (size_t)noise->width + (size_t)(r->x + k % r->width);
            errors[n++] = scale * noise->change[pixel];
        }
    }
    qsort(errors, pixels, sizeof *errors, by_size);
    noise->worst = errors[pixels - left_out];
    free(errors);
}

static double sum_changes(const Noise *noise, const NoiseTile *tile) {
    const Rectangle *r = &tile->pixels;
    float scale = pixel_scale(noise, tile);
    double sum = 0;
    for (int k = 0; k < r->width * r->height; k++) {
        size_t pixel = (size_t)(r->y + k / r->width) * (size_t)noise->width + (size_t)(r->x + k % r->width);
        if (scale * noise->change[pixel] < noise->worst) sum += (double)noise->change[pixel];
    }
    return sum;
}

/* Measures q from all tiles for which two changes are known. */
static void measure_fall(Noise *noise) {
    double change = 0, earlier = 0;
    for (int i = 0; i < count_tiles(noise); i++) {
        if (noise->tiles[i].times < 3) continue;
        change += noise->tiles[i].change;
        earlier += noise->tiles[i].earlier;
    }
    if (!(earlier > 0)) return;
    noise->measured_fall = fmin(fmax(change / earlier, least_fall), independent_fall);
    noise->fall = 0.5 * (independent_fall + noise->measured_fall);
}

void noise_measure(Noise *noise, const Image *mean) {
    size_t values = 4 * (size_t)noise->width * (size_t)noise->height;
    double sum = 0;
    for (int i = 0; i < count_tiles(noise); i++) {
        NoiseTile *tile = &noise->tiles[i];
        if (tile->samples < 2 * tile->measured || tile->samples == 0) continue;
        measure_pixels(noise, tile, mean);
        tile->earlier = tile->change;
        tile->measured = tile->samples;
        tile->times++;
    }
    find_worst(noise);
    for (int i = 0; i < count_tiles(noise); i++)
        noise->tiles[i].change = sum_changes(noise, &noise->tiles[i]);
    measure_fall(noise);
    for (size_t i = 0; i < values; i++) sum += i % 4 < 3 ? (double)mean->rgba[i] : 0;
    noise->mean = sum / (double)(values / 4 * 3);
}

double noise_of_tile(const Noise *noise, const NoiseTile *tile, double samples) {
    if (tile->times < 2) return INFINITY;
    double levels = log2(samples / (double)tile->measured), change = tile->change;
    /* The change before, multiplied by q, estimates the same value. The mean of both has less noise of its
     * own, and so fewer tiles seem to be done too early. */
    if (tile->times > 2) change = 0.5 * (change + noise->measured_fall * tile->earlier);
    return change * noise->fall / (1 - noise->fall) * fallen(noise, levels);
}

double noise_percent(const Noise *noise) {
    double sum = 0, pixels = (double)noise->width * (double)noise->height;
    for (int i = 0; i < count_tiles(noise); i++)
        sum += noise_of_tile(noise, &noise->tiles[i], (double)noise->tiles[i].samples);
    if (!(sum < INFINITY)) return INFINITY;
    return sum > 0 ? certainty * 100 * sqrt(sum / pixels) / noise->mean : 0;
}

double noise_goal(const Noise *noise, double percent) {
    return pow(0.01 * percent / certainty * noise->mean, 2) * noise->width * noise->height;
}

static void calibrate_tile(const Noise *noise, const NoiseTile *tile, float *variance) {
    const Rectangle *r = &tile->pixels;
    double sum = 0, error = noise_of_tile(noise, tile, (double)tile->samples);
    for (int pass = 0; pass < 2; pass++) {
        for (int k = 0; k < 3 * r->width * r->height; k++) {
            int x = r->x + k / 3 % r->width, y = r->y + k / 3 / r->width;
            float *value = &variance[3 * ((size_t)y * (size_t)noise->width + (size_t)x) + (size_t)(k % 3)];
            if (pass == 0) sum += (double)*value / 3;
            if (pass == 1 && sum > 0 && error < INFINITY) *value = (float)(*value * error / sum);
        }
    }
}

void noise_calibrate(const Noise *noise, float *variance) {
    for (int i = 0; i < count_tiles(noise); i++) calibrate_tile(noise, &noise->tiles[i], variance);
}
