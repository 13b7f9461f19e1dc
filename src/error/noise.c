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
 * the true error is below the estimate in nine pictures of ten. In levels, which bend the radiance, they were
 * 0.6 to 1.15 times the estimate with 1.05. */
static const double certainty[NOISE_MEASURES] = {1.05, 1.1};

/* The estimate of an error that is spread over so many pixels as independent numbers errs by 0.7 / sqrt(of
 * them) of itself. Up to this much is within the certainty. */
static const double spread_error = 0.7, spread_within = 0.05;

Noise noise_create(int width, int height, const ToneTable *tone) {
    return noise_create_area(width, height, (Rectangle){0, 0, width, height}, tone);
}

/* Leaves out the pixels outside of the area. */
static void leave_out_rest(Noise *noise) {
    const Rectangle *area = &noise->area;
    for (int y = 0; y < noise->height; y++)
        for (int x = 0; x < noise->width; x++)
            noise->left_out[(size_t)y * (size_t)noise->width + (size_t)x] = !rectangle_holds(area, x, y);
}

Noise noise_create_area(int width, int height, Rectangle area, const ToneTable *tone) {
    Noise noise = {.width = width, .height = height, .area = area, .counted = (long)area.width * area.height};
    size_t pixels = (size_t)width * (size_t)height;
    int first_column = area.x / NOISE_TILE, first_row = area.y / NOISE_TILE;
    noise.columns = (area.x + area.width + NOISE_TILE - 1) / NOISE_TILE - first_column;
    noise.rows = (area.y + area.height + NOISE_TILE - 1) / NOISE_TILE - first_row;
    noise.tiles = memory_get((size_t)noise_tile_count(&noise), sizeof *noise.tiles);
    noise.before = memory_get(3 * pixels, sizeof *noise.before);
    noise.left_out = memory_get(pixels, 1);
    leave_out_rest(&noise);
    if (tone) {
        noise.tone = memory_get(1, sizeof *noise.tone);
        *noise.tone = *tone;
    }
    for (int i = 0; i < NOISE_MEASURES; i++)
        noise.figures[i] = (NoiseFigures){independent_fall, independent_fall, certainty[i]};
    for (int i = 0; i < noise_tile_count(&noise); i++) {
        Rectangle cell = {(first_column + i % noise.columns) * NOISE_TILE,
                          (first_row + i / noise.columns) * NOISE_TILE, NOISE_TILE, NOISE_TILE};
        Rectangle r = rectangle_overlap(&cell, &area);
        noise.tiles[i] = (NoiseTile){.pixels = r, .counted = r.width * r.height};
    }
    return noise;
}

void noise_destroy(Noise *noise) {
    free(noise->tiles);
    free(noise->before);
    free(noise->light.before);
    free(noise->left_out);
    free(noise->tone);
    *noise = (Noise){0};
}

size_t noise_pixel(const Noise *noise, const Rectangle *r, int k) {
    return (size_t)(r->y + k / r->width) * (size_t)noise->width + (size_t)(r->x + k % r->width);
}

void noise_leave_out(Noise *noise, const unsigned char *mask) {
    size_t pixels = (size_t)noise->width * (size_t)noise->height;
    long counted = 0;
    for (size_t i = 0; i < pixels; i++) counted += !(mask[i] || noise->left_out[i]);
    if (!counted) return;
    noise->counted = counted;
    for (size_t i = 0; i < pixels; i++) noise->left_out[i] |= mask[i] != 0;
    for (int i = 0; i < noise_tile_count(noise); i++) {
        const Rectangle *r = &noise->tiles[i].pixels;
        int here = 0;
        for (int k = 0; k < r->width * r->height; k++) here += !noise->left_out[noise_pixel(noise, r, k)];
        noise->tiles[i].counted = here;
    }
}

void noise_show(Noise *noise, double gain) {
    if (!noise->tone || noise->tone->gain == (float)gain) return;
    noise->tone->gain = (float)gain;
    for (int i = 0; i < noise_tile_count(noise); i++)
        if (noise->tiles[i].times)
            noise->tiles[i].change[NOISE_LEVELS].now = noise->tiles[i].light[NOISE_LEVELS].now = INFINITY;
}

bool noise_measures(const Noise *noise, NoiseMeasure measure) {
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

/* Measures how `part`, a part of the picture with 4 floats a pixel, has changed in a row of the tile, and
 * keeps it. In levels, the change is seen on top of the rest of the picture. */
static void measure_row(Noise *noise, const NoiseTile *tile, NoiseChange *changes, const Image *mean,
                        const float *part, float *before, int y) {
    size_t first = (size_t)y * (size_t)noise->width + (size_t)tile->pixels.x;
    for (size_t pixel = first; pixel < first + (size_t)tile->pixels.width; pixel++) {
        const float *whole = mean->rgba + 4 * pixel, *now = part + 4 * pixel;
        float *then = before + 3 * pixel, changed[3];
        for (int c = 0; c < 3; c++) changed[c] = whole[c] - (now[c] - then[c]);
        if (!noise->left_out[pixel]) {
            add_change(&changes[NOISE_RADIANCE], radiance_change(now, then));
            if (noise->tone) add_change(&changes[NOISE_LEVELS], levels_change(noise->tone, whole, changed));
        }
        for (int c = 0; c < 3; c++) then[c] = now[c];
    }
}

/* Notes how much a part of the picture has changed in the pixels of a tile, and keeps it for the next
 * comparison. */
static void measure_part(Noise *noise, const NoiseTile *tile, NoiseChange *changes, const Image *mean,
                         const float *part, float *before) {
    const Rectangle *r = &tile->pixels;
    for (int i = 0; i < NOISE_MEASURES; i++)
        changes[i] = (NoiseChange){.earlier = changes[i].now, .unmet = changes[i].unmet};
    for (int y = r->y; y < r->y + r->height; y++) measure_row(noise, tile, changes, mean, part, before, y);
}

double noise_fallen(const NoiseFigures *figures, double levels) {
    return pow(figures->fall, levels);
}

/* Measures q from all tiles for which two changes are known. */
static void measure_fall(Noise *noise, NoiseMeasure measure) {
    NoiseFigures *figures = &noise->figures[measure];
    double now = 0, earlier = 0;
    for (int i = 0; i < noise_tile_count(noise); i++) {
        if (noise->tiles[i].times < 3) continue;
        now += noise->tiles[i].change[measure].now;
        earlier += noise->tiles[i].change[measure].earlier;
    }
    if (!(earlier > 0 && earlier < INFINITY)) return;
    figures->measured_fall = fmin(fmax(now / earlier, least_fall), independent_fall);
    figures->fall = 0.5 * (independent_fall + figures->measured_fall);
}

double noise_caution(NoiseMeasure measure, double changes, double squares) {
    if (!(squares > 0)) return certainty[measure];
    double pixels = changes * changes / squares;
    return certainty[measure] * (1 + fmax(spread_error / sqrt(pixels) - spread_within, 0));
}

/* The changes of tiles with different numbers of samples are scaled to variances, up to a factor. */
static void measure_caution(Noise *noise, NoiseMeasure measure) {
    NoiseFigures *figures = &noise->figures[measure];
    double changes = 0, squares = 0;
    for (int i = 0; i < noise_tile_count(noise); i++) {
        const NoiseTile *tile = &noise->tiles[i];
        if (tile->times < 2) continue;
        double scale = noise_fallen(figures, log2((double)tile->samples / (double)tile->measured));
        changes += scale * tile->change[measure].now;
        squares += scale * scale * tile->change[measure].squares;
        if (noise->light.times < 2) continue;
        scale = noise->light.measured / noise->light.paths;
        changes += scale * tile->light[measure].now;
        squares += scale * scale * tile->light[measure].squares;
    }
    figures->caution = noise_caution(measure, changes, squares);
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

/* Measures the light of light paths if their number has doubled. */
static void measure_light(Noise *noise, const NoisePicture *picture) {
    NoiseLight *light = &noise->light;
    size_t pixels = (size_t)noise->width * (size_t)noise->height;
    light->paths = picture->light_paths;
    if (!(light->paths > 0) || light->paths < 2 * light->measured) return;
    if (!light->before) light->before = memory_get(3 * pixels, sizeof *light->before);
    for (int i = 0; i < noise_tile_count(noise); i++) {
        NoiseTile *tile = &noise->tiles[i];
        measure_part(noise, tile, tile->light, picture->mean, picture->light, light->before);
    }
    light->measured = light->paths;
    light->times++;
}

/* Measures the light of paths from the camera in the tiles whose samples have doubled. */
static void measure_tiles(Noise *noise, const Image *mean, const float *part) {
    for (int i = 0; i < noise_tile_count(noise); i++) {
        NoiseTile *tile = &noise->tiles[i];
        if (tile->samples < 2 * tile->measured || tile->samples == 0) continue;
        measure_part(noise, tile, tile->change, mean, part, noise->before);
        tile->measured = tile->samples;
        tile->times++;
    }
}

void noise_measure(Noise *noise, const NoisePicture *picture) {
    size_t values = 4 * (size_t)noise->width * (size_t)noise->height;
    const float *part = picture->mean->rgba;
    float *without = NULL;
    if (picture->light) {
        without = memory_get(values, sizeof *without);
        for (size_t i = 0; i < values; i++) without[i] = part[i] - picture->light[i];
        part = without;
        measure_light(noise, picture);
    }
    measure_tiles(noise, picture->mean, part);
    free(without);
    for (NoiseMeasure i = 0; i < NOISE_MEASURES; i++) {
        if (!noise_measures(noise, i)) continue;
        measure_fall(noise, i);
        measure_caution(noise, i);
    }
    measure_mean(noise, picture->mean);
}
