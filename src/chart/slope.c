#include "chart/slope.h"

#include <math.h>

double slope_fit(const double *x, const double *y, int count) {
    double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (int i = 0; i < count; i++) mean_x += log(x[i]) / count, mean_y += log(y[i]) / count;
    for (int i = 0; i < count; i++) {
        double dx = log(x[i]) - mean_x;
        xx += dx * dx;
        xy += dx * (log(y[i]) - mean_y);
    }
    return xx > 0 ? xy / xx : NAN;
}

double slope_departure(const double *x, const double *y, int count) {
    double mean = 0, largest = 0;
    for (int i = 0; i < count; i++) mean += log(y[i] / x[i]) / count;
    for (int i = 0; i < count; i++) largest = fmax(largest, fabs(y[i] / x[i] * exp(-mean) - 1));
    return largest;
}
