/* The wavelengths that colours are computed from, and the matrices that bring their radiances to linear
 * sRGB: tools/spectrum.sh makes this file, and says how.
 *
 * The rows of a matrix are R, G and B. Its columns are the wavelengths, and each row's sum is 1: white is
 * the sun above the air. */
#pragma once

enum { SPECTRUM_FEW = 3, SPECTRUM_MANY = 6 };

static const double spectrum_few_nm[SPECTRUM_FEW] = {610, 550, 450};

static const double spectrum_few[3][SPECTRUM_FEW] = {
    {1.638505, -0.645907, 0.007402},
    {-0.088032, 1.069259, 0.018773},
    {-0.042074, -0.026377, 1.068451},
};

static const double spectrum_many_nm[SPECTRUM_MANY] = {640, 590, 560, 520, 460, 420};

static const double spectrum_many[3][SPECTRUM_MANY] = {
    {0.528309, 0.857580, 0.095262, -0.517785, -0.005322, 0.041956},
    {-0.045494, 0.155519, 0.334822, 0.617962, -0.024999, -0.037810},
    {-0.005033, -0.028680, -0.059782, 0.014831, 0.824251, 0.254413},
};
