/* Fits powers to measurements, to see how a cost grows. All values are above 0. */
#pragma once

/* Returns the exponent s of y = c x^s, by least squares of the logarithms. Returns NaN if fewer than two x
 * differ. */
double slope_fit(const double *x, const double *y, int count);

/* Returns how far y is from proportional to x: the largest |y / (c x) - 1|, for the c that fits the
 * logarithms best. */
double slope_departure(const double *x, const double *y, int count);
