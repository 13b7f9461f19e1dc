#include "image/compare.h"

#include "base/budget.h"
#include "base/memory.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What one pass over the pictures gathers. */
typedef struct Gathered {
    long count;            /* finite pixels */
    double a[3], b[3];     /* sums, a channel each */
    double squares;        /* sum of (a - b)^2 */
    double *pixel_squares; /* the same, a pixel each */
    double *pixel_b;       /* the sum of b's channels, a pixel each */
    double *distances;     /* |a - b|, three a pixel */
    long z_count, z_above_4;
    double z_squares;
} Gathered;

/* What of the picture its file held, in parentheses, if that was a part; else "". */
static void part_print(const Image *image, char *text, size_t size) {
    const Rectangle *data = &image->data;
    *text = 0;
    if (data->width)
        snprintf(text, size, " (its display window; its data are %dx%d at %d,%d)", data->width, data->height,
                 data->x, data->y);
}

static bool size_check(const Image *image, const Image *b, const char *what, Error *error) {
    if (!image || (image->width == b->width && image->height == b->height)) return true;
    char part[128], part_b[128];
    part_print(image, part, sizeof part);
    part_print(b, part_b, sizeof part_b);
    return error_set(error, STATUS_USAGE,
                     "%s is %dx%d%s, the reference %dx%d%s: they must have the same size", what, image->width,
                     image->height, part, b->width, b->height, part_b);
}

static bool pixel_is_finite(const float *a, const float *b) {
    for (int c = 0; c < 3; c++) {
        if (!isfinite(a[c]) || !isfinite(b[c])) return false;
    }
    return true;
}

static void gather_z(Gathered *sums, double difference, double standard_error) {
    if (!(standard_error > 0) || !isfinite(standard_error)) return;
    double z = difference / standard_error;
    sums->z_count++;
    sums->z_squares += z * z;
    sums->z_above_4 += fabs(z) > 4;
}

static void gather_pixel(Gathered *sums, const float *a, const float *b, const float *standard_error) {
    double square = 0;
    for (int c = 0; c < 3; c++) {
        double difference = (double)a[c] - (double)b[c];
        square += difference * difference;
        sums->a[c] += (double)a[c];
        sums->b[c] += (double)b[c];
        sums->distances[3 * sums->count + c] = fabs(difference);
        if (standard_error) gather_z(sums, difference, (double)standard_error[c]);
    }
    sums->squares += square;
    sums->pixel_b[sums->count] = (double)b[0] + (double)b[1] + (double)b[2];
    sums->pixel_squares[sums->count++] = square;
}

/* Hoare's selection: afterwards values[k] is where sorting would put it, with none smaller behind it. */
static void select_smallest(double *values, long count, long k) {
    long low = 0, high = count - 1;
    while (low < high) {
        double pivot = values[low + (high - low) / 2];
        long i = low, j = high;
        while (i <= j) {
            while (values[i] < pivot) i++;
            while (values[j] > pivot) j--;
            if (i <= j) {
                double swapped = values[i];
                values[i++] = values[j];
                values[j--] = swapped;
            }
        }
        if (k <= j) {
            high = j;
        } else if (k >= i) {
            low = i;
        } else {
            return;
        }
    }
}

static double percent_of(double value, double mean) {
    return value == 0 ? 0 : mean == 0 ? INFINITY : 100 * value / mean;
}

/* Root of the mean square difference / mean(b), without the 0.1 % of pixels that differ most; one always
 * remains. */
static double trimmed_percent(const Gathered *sums) {
    long dropped = (sums->count + 999) / 1000;
    long kept = sums->count > dropped ? sums->count - dropped : 1;
    double *ranked = memory_get((size_t)sums->count, sizeof *ranked);
    memcpy(ranked, sums->pixel_squares, (size_t)sums->count * sizeof *ranked);
    select_smallest(ranked, sums->count, kept - 1);
    double largest = ranked[kept - 1], squares = 0, b = 0;
    free(ranked);

    /* Of the pixels that differ just as much as the last that is kept, the first ones are kept. */
    long equal = kept;
    for (long i = 0; i < sums->count; i++) equal -= sums->pixel_squares[i] < largest;
    for (long i = 0; i < sums->count; i++) {
        double square = sums->pixel_squares[i];
        if (square > largest || (square == largest && equal-- <= 0)) continue;
        squares += square;
        b += sums->pixel_b[i];
    }
    double values = 3.0 * (double)kept;
    return percent_of(sqrt(squares / values), fabs(b) / values);
}

static void figures_fill(Comparison *result, Gathered *sums) {
    long values = 3 * sums->count;
    double mean = fabs(sums->b[0] + sums->b[1] + sums->b[2]) / (double)values;
    result->rel_rmse_percent = percent_of(sqrt(sums->squares / (double)values), mean);
    result->trimmed_percent = trimmed_percent(sums);
    for (int c = 0; c < 3; c++) result->bias_percent[c] = percent_of(sums->a[c] - sums->b[c], sums->b[c]);

    double largest = 0;
    for (long i = 0; i < values; i++) largest = fmax(largest, sums->distances[i]);
    result->largest_percent = percent_of(largest, mean);
    long rank = values - values / 100; /* ceil(0.99 values) */
    select_smallest(sums->distances, values, rank - 1);
    result->p99_percent = percent_of(sums->distances[rank - 1], mean);

    result->has_z = sums->z_count > 0;
    if (result->has_z) {
        result->mean_z2 = sums->z_squares / (double)sums->z_count;
        result->share_z4_percent = 100 * (double)sums->z_above_4 / (double)sums->z_count;
    }
}

static bool sizes_check(const Image *a, const Image *b, const CompareOptions *options, Error *error) {
    return size_check(a, b, "the picture", error) &&
           size_check(options->standard_error, b, "the picture of standard errors", error) &&
           size_check(options->mask, b, "the mask", error);
}

/* Gathers the pixels that are compared, and marks them. */
static void gather(Gathered *sums, const Image *a, const Image *b, const CompareOptions *options,
                   unsigned char *compared, Comparison *result) {
    const Image *mask = options->mask, *standard_error = options->standard_error;
    size_t pixels = (size_t)b->width * (size_t)b->height;
    for (size_t pixel = 0, i = 0; pixel < pixels; pixel++, i += 4) {
        if (mask && !(mask->rgba[i] > 0.5F)) continue;
        if (options->sun && options->sun[pixel]) {
            result->sun_pixels++;
            continue;
        }
        int x = (int)(pixel % (size_t)b->width), y = (int)(pixel / (size_t)b->width);
        if (!image_holds(a, x, y) || !image_holds(b, x, y)) {
            result->outside++;
            continue;
        }
        result->pixels++;
        compared[pixel] = pixel_is_finite(a->rgba + i, b->rgba + i);
        if (compared[pixel]) {
            gather_pixel(sums, a->rgba + i, b->rgba + i, standard_error ? standard_error->rgba + i : NULL);
        } else if (!result->nonfinite++) {
            result->nonfinite_x = x;
            result->nonfinite_y = y;
        }
    }
}

/* What a comparison takes for each pixel, with the marks of the command. */
enum { BYTES_A_PIXEL = 52 };

bool compare_images(const Image *a, const Image *b, const CompareOptions *options, Comparison *result,
                    Error *error) {
    static const CompareOptions defaults = {0};
    if (!options) options = &defaults;
    *result = (Comparison){0};
    if (!sizes_check(a, b, options, error)) return false;

    size_t pixels = (size_t)b->width * (size_t)b->height;
    if (!budget_take(pixels * BYTES_A_PIXEL, SIZE_MAX, STATUS_FAILURE, "the comparison", error)) return false;
    Gathered sums = {.pixel_squares = memory_get(pixels, sizeof(double)),
                     .pixel_b = memory_get(pixels, sizeof(double)),
                     .distances = memory_get(pixels, 3 * sizeof(double))};
    unsigned char *compared = memory_get(pixels, 1);
    gather(&sums, a, b, options, compared, result);
    result->levels_only = a->shown || b->shown;
    result->levels = levels_compare(a, b, compared, options->tone, options->exposure_ev);
    if (sums.count) {
        figures_fill(result, &sums);
    } else {
        result->rel_rmse_percent = result->trimmed_percent = INFINITY;
        result->largest_percent = result->p99_percent = INFINITY;
        for (int c = 0; c < 3; c++) result->bias_percent[c] = INFINITY;
    }
    if (options->compared) memcpy(options->compared, compared, pixels);
    free(compared);
    free(sums.pixel_squares);
    free(sums.pixel_b);
    free(sums.distances);
    if (result->pixels) return true;
    return error_set(error, STATUS_USAGE, "no pixel to compare: %s",
                     result->outside      ? "no file holds what the other one does"
                     : result->sun_pixels ? "all hold the sun's own image"
                                          : "the mask admits none");
}
