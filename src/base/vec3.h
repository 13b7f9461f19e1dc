/* Vectors of three doubles, and the two constants of angles. */
#pragma once

#include <math.h>

static const double pi = 3.14159265358979323846;

/* Radians in a degree. */
static const double degree = 3.14159265358979323846 / 180;

static inline double vec3_dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double vec3_length(const double v[3]) {
    return sqrt(vec3_dot(v, v));
}

/* The results below are written to `out`, which may be one of the arguments except in vec3_cross(). */

static inline void vec3_cross(const double a[3], const double b[3], double out[3]) {
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static inline void vec3_subtract(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++) out[i] = a[i] - b[i];
}

static inline void vec3_scale(const double v[3], double factor, double out[3]) {
    for (int i = 0; i < 3; i++) out[i] = v[i] * factor;
}

static inline void vec3_normalize(const double v[3], double out[3]) {
    double length = vec3_length(v);
    for (int i = 0; i < 3; i++) out[i] = v[i] / length;
}
