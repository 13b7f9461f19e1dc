#include "error/merge_layers.h"

#include "base/memory.h"
#include "image/format.h"
#include "render/aov.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What render/aov.c calls its layers, and how image_read_as() finds them. */
static const struct {
    unsigned kind;
    const char *layer, *name, *channels;
} rows[] = {{AOV_ALBEDO, "albedo", "albedo", "RGB"},
            {AOV_NORMAL, "normal", "normal", "XYZ"},
            {AOV_DEPTH, "Z", "", "Z"},
            {AOV_TRANSMITTANCE, "transmittance", "transmittance", "Y"}};

enum { ROWS = sizeof rows / sizeof *rows };

static bool read_layer(const Part *part, const char *layer, Image *image, const Merge *merge, Error *error) {
    ImageReadParams params = {.layer = layer};
    if (!image_read_as(image, part->path, &params, error)) return false;
    if (image->width == merge->width && image->height == merge->height) return true;
    image_free(image);
    return error_set(error, STATUS_FAILURE, "%s: its layer '%s' has another size", part->path, layer);
}

/* How many of the samples of which one run would take the layers a part has; at least a trace of them, for
 * pixels of which no part has any. */
static double weight_of(const Part *part) {
    double first = (double)part->pieces[0].first, end = first + (double)part->pieces[0].count;
    return fmax(fmin(end, AOV_MOST_SAMPLES) - first, 1e-9);
}

/* Adds a part's layer. A depth of nothing has no weight beside others. */
static void add(const Part *part, const Image *from, int row, size_t channels, double *sums,
                double *weights) {
    for (int y = 0; y < from->height; y++) {
        for (int x = 0; x < from->width; x++) {
            size_t pixel = (size_t)y * (size_t)from->width + (size_t)x;
            if (!part_holds(part, x, y)) continue;
            bool nothing = rows[row].kind == AOV_DEPTH && from->rgba[4 * pixel] >= 1e10f;
            double weight = weight_of(part) * (nothing ? 1e-30 : 1);
            for (size_t c = 0; c < channels; c++)
                sums[channels * pixel + c] += weight * (double)from->rgba[4 * pixel + c];
            weights[pixel] += weight;
        }
    }
}

static bool add_row(Merge *merge, int row, Error *error) {
    size_t pixels = (size_t)merge->width * (size_t)merge->height, channels = strlen(rows[row].channels);
    float *data = image_add_layer(&merge->image, rows[row].name, rows[row].channels);
    double *sums = memory_get(channels * pixels, sizeof *sums),
           *weights = memory_get(pixels, sizeof *weights);
    bool ok = true;
    for (int i = 0; ok && i < merge->count; i++) {
        Image layer;
        ok = read_layer(&merge->parts[i], rows[row].layer, &layer, merge, error);
        if (!ok) break;
        add(&merge->parts[i], &layer, row, channels, sums, weights);
        image_free(&layer);
    }
    for (size_t i = 0; ok && i < channels * pixels; i++)
        if (weights[i / channels] > 0) data[i] = (float)(sums[i] / weights[i / channels]);
    free(sums);
    free(weights);
    return ok;
}

bool merge_layers_add(Merge *merge, const double *samples, Error *error) {
    unsigned kinds;
    size_t pixels = (size_t)merge->width * (size_t)merge->height;
    if (!aov_parse(part_attribute(&merge->parts[0], "magichour.aov"), &kinds, error)) return false;
    for (int i = 0; i < ROWS; i++)
        if (kinds & rows[i].kind && !add_row(merge, i, error)) return false;
    if (!(kinds & AOV_SAMPLES)) return true;
    float *data = image_add_layer(&merge->image, "samples", "Y");
    for (size_t i = 0; i < pixels; i++) data[i] = (float)samples[i];
    return true;
}
