/* How a cost grows: powers fitted to measurements. All values are above 0. */
#pragma once

/* The exponent s of y = c x^s by least squares of the logarithms; NaN with fewer than two different x. */
double slope_fit(const double *x, const double *y, int count);

/* The largest |y / (c x) - 1| for the c that is best for the logarithms: how far from proportional. */
double slope_departure(const double *x, const double *y, int count);
