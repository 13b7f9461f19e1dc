#include "error/merge_sums.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t pixel_count(const MergeSums *sums) {
    return (size_t)sums->width * (size_t)sums->height;
}

/* Knuth's exact sum of two doubles, with what was lost added to the low part. The two parts hold 106 bits:
 * all that the floats of any part have. */
static void add(ExactSum *sum, double value) {
    double next = sum->high + value, added = next - sum->high;
    double lost = (sum->high - (next - added)) + (value - added);
    double low = sum->low + lost, high = next + low;
    sum->low = low - (high - next);
    sum->high = high;
}

static bool has(unsigned layers, int layer) {
    return layers >> layer & 1;
}

MergeSums merge_sums_create(int width, int height, const Part *part) {
    MergeSums sums = {
        .width = width, .height = height, .layers = part->layers, .light_scale = part->light_scale};
    size_t pixels = pixel_count(&sums);
    sums.radiance = memory_get(3 * pixels, sizeof *sums.radiance);
    sums.accepted = memory_get(pixels, sizeof *sums.accepted);
    sums.rejected = memory_get(pixels, sizeof *sums.rejected);
    if (has(part->layers, PART_LIGHT)) {
        sums.light = memory_get(3 * pixels, sizeof *sums.light);
        sums.light_paths = memory_get(pixels, sizeof *sums.light_paths);
    }
    if (has(part->layers, PART_SCATTER)) sums.scatter = memory_get(4 * pixels, sizeof *sums.scatter);
    if (has(part->layers, PART_CHANCE)) sums.chance = memory_get(4 * pixels, sizeof *sums.chance);
    if (has(part->layers, PART_SQUARES)) sums.squares = memory_get(4 * pixels, sizeof *sums.squares);
    return sums;
}

void merge_sums_free(MergeSums *sums) {
    free(sums->radiance);
    free(sums->light);
    free(sums->accepted);
    free(sums->rejected);
    free(sums->light_paths);
    free(sums->scatter);
    free(sums->chance);
    free(sums->squares);
    *sums = (MergeSums){0};
}

/* What the scatter of two lots of groups is together (Chan, Golub and LeVeque 1979): before the new samples
 * are added. */
static void add_scatter(MergeSums *sums, size_t pixel, const float *sum, const float *rest,
                        const float *scatter) {
    double before = sums->accepted[pixel], now = (double)sum[3];
    double *to = sums->scatter + 4 * pixel;
    for (int c = 0; c < 3; c++) {
        const ExactSum *old = &sums->radiance[3 * pixel + (size_t)c];
        double difference =
            ((double)sum[c] + (double)rest[c]) / fmax(now, 1) - (old->high + old->low) / fmax(before, 1);
        to[c] += (double)scatter[c] + difference * difference * before * now / fmax(before + now, 1);
    }
    to[3] += (double)scatter[3];
}

/* Sums in the first three channels, and a set of bits in the fourth. */
static void add_chance(double *to, const float *from) {
    for (int c = 0; c < 3; c++) to[c] += (double)from[c];
    to[3] = (double)((unsigned)to[3] | (from[3] > 0 ? (unsigned)from[3] : 0U));
}

/* Whether a layer's numbers of a pixel can be: sums that are finite but for the scatter, which may be
 * unknown, and in alpha whole counts or sets of bits. */
static bool is_sane(int layer, const float *value) {
    static const float most_count = 0x1p36F, most_bits = 0x1p24F;
    bool bits = layer == PART_CHANCE || layer == PART_SQUARES,
         light = layer == PART_LIGHT || layer == PART_LIGHT_REST;
    for (int c = 0; layer != PART_SCATTER && c < 3; c++)
        if (!isfinite(value[c])) return false;
    return light || (value[3] >= 0 && value[3] <= (bits ? most_bits : most_count));
}

static void add_pixel(MergeSums *sums, size_t pixel, const Image *layers, double light_paths) {
    const float *sum = layers[PART_SUM].rgba + 4 * pixel, *rest = layers[PART_REST].rgba + 4 * pixel;
    if (sums->scatter) add_scatter(sums, pixel, sum, rest, layers[PART_SCATTER].rgba + 4 * pixel);
    for (size_t c = 0; c < 3; c++) {
        add(&sums->radiance[3 * pixel + c], (double)sum[c]);
        add(&sums->radiance[3 * pixel + c], (double)rest[c]);
        if (!sums->light) continue;
        add(&sums->light[3 * pixel + c], (double)layers[PART_LIGHT].rgba[4 * pixel + c]);
        add(&sums->light[3 * pixel + c], (double)layers[PART_LIGHT_REST].rgba[4 * pixel + c]);
    }
    if (sums->light) sums->light_paths[pixel] += light_paths;
    sums->accepted[pixel] += (double)sum[3];
    sums->rejected[pixel] += (double)rest[3];
    if (sums->chance) add_chance(sums->chance + 4 * pixel, layers[PART_CHANCE].rgba + 4 * pixel);
    if (sums->squares) add_chance(sums->squares + 4 * pixel, layers[PART_SQUARES].rgba + 4 * pixel);
}

/* Adds the pixels that the part has. Returns false if one of them has numbers that no film has. */
static bool add_pixels(MergeSums *sums, const Part *part, const Image *layers) {
    for (size_t pixel = 0; pixel < pixel_count(sums); pixel++) {
        int x = (int)(pixel % (size_t)sums->width), y = (int)(pixel / (size_t)sums->width);
        if (!part_holds(part, x, y)) continue;
        for (int i = 0; i < PART_LAYERS; i++)
            if (has(sums->layers, i) && !is_sane(i, layers[i].rgba + 4 * pixel)) return false;
        add_pixel(sums, pixel, layers, part->light_paths);
    }
    return true;
}

bool merge_sums_add(MergeSums *sums, const Part *part, Error *error) {
    Image layers[PART_LAYERS] = {{0}};
    bool ok = true;
    for (int i = 0; ok && i < PART_LAYERS; i++) {
        if (!has(sums->layers, i)) continue;
        ok = part_read_layer(part, i, &layers[i], error);
        if (ok && (layers[i].width != sums->width || layers[i].height != sums->height))
            ok = error_set(error, STATUS_FAILURE, "%s: it is of %dx%d, and the others of %dx%d", part->path,
                           layers[i].width, layers[i].height, sums->width, sums->height);
    }
    ok = ok && (add_pixels(sums, part, layers) ||
                error_set(error, STATUS_FAILURE, "%s: its sums are not those of a picture", part->path));
    for (int i = 0; i < PART_LAYERS; i++) image_free(&layers[i]);
    return ok;
}

Image merge_sums_mean(const MergeSums *sums, float **light) {
    Image image = image_create(sums->width, sums->height);
    *light = sums->light ? memory_get(4 * pixel_count(sums), sizeof **light) : NULL;
    for (size_t i = 0; i < pixel_count(sums); i++) {
        float *pixel = image.rgba + 4 * i;
        for (size_t c = 0; c < 3; c++) {
            pixel[c] = film_mean(sums->radiance[3 * i + c].high, sums->accepted[i]);
            if (sums->light && sums->light_paths[i] > 0)
                pixel[c] += (*light)[4 * i + c] =
                    film_light_mean(sums->light[3 * i + c].high, sums->light_scale, sums->light_paths[i]);
        }
        pixel[3] = sums->accepted[i] > 0 ? 1.0f : 0.0f;
    }
    return image;
}

static float *floats_of(const double *from, size_t count) {
    float *to = memory_get(count, sizeof *to);
    for (size_t i = 0; i < count; i++) to[i] = (float)from[i];
    return to;
}

ChanceMap merge_sums_chance(const MergeSums *sums) {
    if (!sums->chance || !sums->squares) return (ChanceMap){0};
    size_t pixels = pixel_count(sums);
    return (ChanceMap){pixels, floats_of(sums->chance, 4 * pixels), floats_of(sums->squares, 4 * pixels),
                       floats_of(sums->accepted, pixels)};
}

/* Writes exact sums as two floats each. */
static void split(const ExactSum *sums, size_t pixels, float *first, float *second) {
    for (size_t i = 0; i < 3 * pixels; i++) {
        size_t at = i / 3 * 4 + i % 3;
        first[at] = (float)sums[i].high;
        second[at] = (float)((sums[i].high - (double)first[at]) + sums[i].low);
    }
}

static void copy(const double *from, size_t pixels, float *to) {
    for (size_t i = 0; i < 4 * pixels; i++) to[i] = (float)from[i];
}

void merge_sums_add_layers(const MergeSums *sums, Image *image) {
    float *layers[PART_LAYERS] = {NULL};
    size_t pixels = pixel_count(sums);
    for (int i = 0; i < PART_LAYERS; i++)
        if (has(sums->layers, i)) layers[i] = image_add_layer(image, part_layer(i), "RGBA");
    split(sums->radiance, pixels, layers[PART_SUM], layers[PART_REST]);
    for (size_t i = 0; i < pixels; i++) {
        layers[PART_SUM][4 * i + 3] = (float)sums->accepted[i];
        layers[PART_REST][4 * i + 3] = (float)sums->rejected[i];
    }
    if (sums->light) split(sums->light, pixels, layers[PART_LIGHT], layers[PART_LIGHT_REST]);
    if (sums->scatter) copy(sums->scatter, pixels, layers[PART_SCATTER]);
    if (sums->chance) copy(sums->chance, pixels, layers[PART_CHANCE]);
    if (sums->squares) copy(sums->squares, pixels, layers[PART_SQUARES]);
}

void merge_sums_variance(const MergeSums *sums, float *rgb) {
    for (size_t i = 0; i < 3 * pixel_count(sums); i++) {
        const double *pixel = sums->scatter + i / 3 * 4;
        rgb[i] = pixel[3] >= 2 ? (float)(pixel[i % 3] / (pixel[3] - 1) / sums->accepted[i / 3]) : NAN;
    }
}
