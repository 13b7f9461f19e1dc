#include "chart/sky_error.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

/* A millionth of the zenith's radiance with the sun at the zenith, from light that was scattered once. */
static const double floor_radiance[3] = {1.43e-6, 1.47e-6, 1.54e-6};

static int by_size(const void *left, const void *right) {
    double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

SkyError sky_error(const float *radiances, const double *truth, int count) {
    size_t values = 3 * (size_t)count;
    double *errors = memory_get(values, sizeof *errors), squares = 0;
    for (size_t i = 0; i < values; i++) {
        double got = (double)radiances[4 * (i / 3) + i % 3];
        errors[i] = 100 * fabs(got - truth[i]) / fmax(truth[i], floor_radiance[i % 3]);
        squares += errors[i] * errors[i];
    }
    qsort(errors, values, sizeof *errors, by_size);
    SkyError error = {sqrt(squares / (double)values), errors[values * 99 / 100], errors[values - 1]};
    free(errors);
    return error;
}
