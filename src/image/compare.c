#include "image/compare.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

/* What one pass over the pictures gathers. */
typedef struct Gathered {
    long count;            /* finite pixels */
    double a[3], b[3];     /* sums, a channel each */
    double squares;        /* sum of (a - b)^2 */
    double *pixel_squares; /* the same, a pixel each */
    double *distances;     /* |a - b|, three a pixel */
    long z_count, z_above_4;
    double z_squares;
} Gathered;

static bool size_check(const Image *image, const Image *b, const char *what, Error *error) {
    if (!image || (image->width == b->width && image->height == b->height)) return true;
    return error_set(error, STATUS_USAGE, "%s is %dx%d, the reference %dx%d: they must have the same size",
                     what, image->width, image->height, b->width, b->height);
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

/* Root of the mean square difference without the 0.1 % of pixels that differ most; one always remains. */
static double trimmed_rms(Gathered *sums) {
    long dropped = (sums->count + 999) / 1000;
    long kept = sums->count > dropped ? sums->count - dropped : 1;
    select_smallest(sums->pixel_squares, sums->count, kept - 1);
    double squares = 0;
    for (long i = 0; i < kept; i++) squares += sums->pixel_squares[i];
    return sqrt(squares / (3.0 * (double)kept));
}

static void figures_fill(Comparison *result, Gathered *sums) {
    long values = 3 * sums->count;
    double mean = fabs(sums->b[0] + sums->b[1] + sums->b[2]) / (double)values;
    result->rel_rmse_percent = percent_of(sqrt(sums->squares / (double)values), mean);
    result->trimmed_percent = percent_of(trimmed_rms(sums), mean);
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

bool compare_images(const Image *a, const Image *b, const Image *standard_error, const Image *mask,
                    Comparison *result, Error *error) {
    *result = (Comparison){0};
    if (!size_check(a, b, "the picture", error)) return false;
    if (!size_check(standard_error, b, "the picture of standard errors", error)) return false;
    if (!size_check(mask, b, "the mask", error)) return false;

    size_t pixels = (size_t)b->width * (size_t)b->height;
    Gathered sums = {.pixel_squares = memory_get(pixels, sizeof(double)),
                     .distances = memory_get(pixels, 3 * sizeof(double))};
    for (size_t i = 0; i < 4 * pixels; i += 4) {
        if (mask && !(mask->rgba[i] > 0.5F)) continue;
        result->pixels++;
        if (pixel_is_finite(a->rgba + i, b->rgba + i)) {
            gather_pixel(&sums, a->rgba + i, b->rgba + i, standard_error ? standard_error->rgba + i : NULL);
        } else {
            result->nonfinite++;
        }
    }
    if (sums.count) {
        figures_fill(result, &sums);
    } else {
        result->rel_rmse_percent = result->trimmed_percent = INFINITY;
        result->largest_percent = result->p99_percent = INFINITY;
        for (int c = 0; c < 3; c++) result->bias_percent[c] = INFINITY;
    }
    free(sums.pixel_squares);
    free(sums.distances);
    return result->pixels ? true
                          : error_set(error, STATUS_USAGE, "no pixel to compare: the mask admits none");
}
