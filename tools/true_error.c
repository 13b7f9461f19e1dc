/* The true error of a picture, by a reference whose own noise is taken off. It is called by tools/honesty.sh.
 *
 * true_error PICTURE HALF HALF   reads a picture and the halves of its reference, two EXR files that differ
 * by noise alone. It prints "percent" with the picture's relRMSE, "levels" with its RMS in 8-bit levels, and
 * "tile" with that of the worst tile of 16x16 pixels, each with the noise of the halves' mean. The pixels of
 * the sun's image that the picture names are left out.
 *
 * The squared difference to a half is, on average, the squared error of the picture and that of the half. The
 * squared difference of the halves is the squared errors of both. So the picture's squared error is the mean
 * of the first over the halves, without half of the second. */
#include "base/memory.h"
#include "base/number.h"
#include "image/compare.h"
#include "image/format.h"
#include "image/sun_pixels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct Study {
    Image picture, halves[2], tile;
    unsigned char *sun;
    /* The picture's file, for its metadata. */
    Text bytes;
} Study;

/* An error and the reference's noise, squared. */
typedef struct Squares {
    double error, noise;
} Squares;

/* That at which the picture is shown. */
static double exposure_of(const Text *file) {
    Text text = {0};
    double exposure_ev;
    if (!image_attribute(file, "magichour.exposure", &text) ||
        !number_parse(text_string(&text), &exposure_ev))
        exposure_ev = 0;
    text_free(&text);
    return exposure_ev;
}

static bool read_all(Study *study, char **files, Error *error) {
    Text text = {0};
    if (!image_read_as(&study->picture, files[0], &(ImageReadParams){.bytes = &study->bytes}, error) ||
        !image_read(&study->halves[0], files[1], error) || !image_read(&study->halves[1], files[2], error))
        return false;
    int width = study->picture.width, height = study->picture.height;
    study->sun = memory_get((size_t)width * (size_t)height, 1);
    bool ok = !image_attribute(&study->bytes, SUN_PIXELS_ATTRIBUTE, &text) ||
              sun_pixels_parse(text_string(&text), study->sun, width, height, error);
    text_free(&text);
    study->tile = image_create(width, height);
    return ok;
}

static double square(double value) {
    return value * value;
}

static Squares squares_of(double a, double b, double between) {
    return (Squares){fmax((square(a) + square(b) - square(between)) / 2, 0), square(between) / 4};
}

/* Fails if no pixel is left to compare, too. */
static bool measure(const Study *study, const CompareOptions *how, Squares *percent, Squares *levels,
                    Error *error) {
    const Image *halves = study->halves;
    Comparison a, b, between;
    if (!compare_images(&study->picture, &halves[0], how, &a, error) ||
        !compare_images(&study->picture, &halves[1], how, &b, error) ||
        !compare_images(&halves[0], &halves[1], how, &between, error))
        return false;
    *percent = squares_of(a.rel_rmse_percent, b.rel_rmse_percent, between.rel_rmse_percent);
    *levels = squares_of(a.levels.rms, b.levels.rms, between.levels.rms);
    return true;
}

/* Admits the pixels of one tile, and says how many of them are to be compared. */
static int admit_tile(Study *study, int left, int top) {
    int count = 0, width = study->tile.width, height = study->tile.height;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            bool inside = x / LEVELS_TILE == left && y / LEVELS_TILE == top;
            size_t pixel = (size_t)y * (size_t)width + (size_t)x;
            study->tile.rgba[4 * pixel] = inside ? 1 : 0;
            count += inside && !study->sun[pixel];
        }
    return count;
}

static bool worst_tile(Study *study, CompareOptions how, Squares *worst, Error *error) {
    Squares percent, tile;
    how.mask = &study->tile;
    *worst = (Squares){0, 0};
    for (int top = 0; top * LEVELS_TILE < study->tile.height; top++)
        for (int left = 0; left * LEVELS_TILE < study->tile.width; left++) {
            if (admit_tile(study, left, top) < LEVELS_TILE_LEAST) continue;
            if (!measure(study, &how, &percent, &tile, error)) return false;
            worst->error = fmax(worst->error, tile.error);
            worst->noise = fmax(worst->noise, tile.noise);
        }
    return true;
}

static void print(const char *name, Squares squares) {
    printf("%s %.4f %.4f\n", name, sqrt(squares.error), sqrt(squares.noise));
}

int main(int count, char **arguments) {
    Study study = {0};
    Error error = {0};
    Squares percent, levels, tile;
    if (count != 4) {
        fprintf(stderr, "true_error: PICTURE HALF HALF\n");
        return STATUS_USAGE;
    }
    if (!read_all(&study, arguments + 1, &error)) {
        fprintf(stderr, "true_error: %s\n", error.text);
        return STATUS_FAILURE;
    }
    CompareOptions how = {.tone = TONE_AUTHOR, .exposure_ev = exposure_of(&study.bytes), .sun = study.sun};
    if (!measure(&study, &how, &percent, &levels, &error) || !worst_tile(&study, how, &tile, &error)) {
        fprintf(stderr, "true_error: %s: %s\n", arguments[1], error.text);
        return STATUS_FAILURE;
    }
    print("percent", percent);
    print("levels", levels);
    print("tile", tile);
    image_free(&study.picture);
    image_free(&study.halves[0]);
    image_free(&study.halves[1]);
    image_free(&study.tile);
    text_free(&study.bytes);
    free(study.sun);
    return STATUS_DONE;
}
