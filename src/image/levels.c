#include "image/levels.h"

#include <math.h>

typedef struct Sum {
    double squares;
    long pixels;
} Sum;

static double root(Sum sum) {
    return sqrt(sum.squares / (3.0 * (double)sum.pixels));
}

double image_level(const Image *image, size_t i, Tone tone, double exposure_ev) {
    double value = (double)image->rgba[i];
    return image->shown ? tone_level(TONE_NONE, 1, value) : tone_level(tone, exp2(exposure_ev), value);
}

static Sum tile_sum(const Image *a, const Image *b, const unsigned char *compared, Tone tone,
                    double exposure_ev, int left, int top) {
    Sum sum = {0};
    for (int y = top; y < top + LEVELS_TILE && y < b->height; y++) {
        for (int x = left; x < left + LEVELS_TILE && x < b->width; x++) {
            size_t pixel = (size_t)y * (size_t)b->width + (size_t)x;
            if (!compared[pixel]) continue;
            sum.pixels++;
            for (size_t i = 4 * pixel; i < 4 * pixel + 3; i++) {
                double difference =
                    image_level(a, i, tone, exposure_ev) - image_level(b, i, tone, exposure_ev);
                sum.squares += difference * difference;
            }
        }
    }
    return sum;
}

Levels levels_compare(const Image *a, const Image *b, const unsigned char *compared, Tone tone,
                      double exposure_ev) {
    Levels levels = {.worst_tile = -1};
    Sum all = {0};
    for (int y = 0; y < b->height; y += LEVELS_TILE) {
        for (int x = 0; x < b->width; x += LEVELS_TILE) {
            Sum tile = tile_sum(a, b, compared, tone, exposure_ev, x, y);
            all.squares += tile.squares;
            all.pixels += tile.pixels;
            if (tile.pixels < LEVELS_TILE_LEAST || root(tile) <= levels.worst_tile) continue;
            levels.worst_tile = root(tile);
            levels.worst_x = x;
            levels.worst_y = y;
        }
    }
    levels.rms = all.pixels ? root(all) : INFINITY;
    if (levels.worst_tile < 0) levels.worst_tile = levels.rms;
    return levels;
}
