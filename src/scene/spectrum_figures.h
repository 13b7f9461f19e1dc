/* The wavelengths that colours are computed from, and the matrices that bring their radiances to linear sRGB:
 * tools/spectrum.sh makes this file, and says how.
 *
 * The rows of a matrix are R, G and B. Its columns are the wavelengths, and each row's sum is 1: white is the
 * sun above the air. */
#pragma once

enum { SPECTRUM_FEW = 3, SPECTRUM_MANY = 6 };

static const double spectrum_few_nm[SPECTRUM_FEW] = {620, 540, 450};

static const double spectrum_few[3][SPECTRUM_FEW] = {
    {1.190, -0.120, -0.070},
    {-0.024, 1.068, -0.044},
    {-0.024, -0.057, 1.081},
};

static const double spectrum_many_nm[SPECTRUM_MANY] = {640, 620, 590, 540, 490, 440};

static const double spectrum_many[3][SPECTRUM_MANY] = {
    {0, 1.190, 0, -0.120, 0, -0.070},
    {0, -0.024, 0, 1.068, 0, -0.044},
    {0, -0.024, 0, -0.057, 0, 1.081},
};
