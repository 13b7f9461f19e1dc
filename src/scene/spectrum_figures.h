/* The wavelengths that colours are computed from, and the matrices that bring their radiances to linear
 * sRGB: tools/spectrum.sh makes this file, and says how.
 *
 * The rows of a matrix are R, G and B. Its columns are the wavelengths, and each row's sum is 1: white is
 * the sun above the air. */
#pragma once

enum { SPECTRUM_FEW = 3, SPECTRUM_MANY = 6 };

static const double spectrum_few_nm[SPECTRUM_FEW] = {610, 550, 450};

static const double spectrum_few[3][SPECTRUM_FEW] = {
    {1.644239, -0.654344, 0.010105},
    {-0.096536, 1.080746, 0.015790},
    {-0.031368, -0.041087, 1.072455},
};

static const double spectrum_many_nm[SPECTRUM_MANY] = {640, 590, 560, 520, 460, 420};

static const double spectrum_many[3][SPECTRUM_MANY] = {
    {0.527488, 0.867667, 0.096080, -0.542962, 0.018676, 0.033051},
    {-0.045588, 0.154291, 0.332835, 0.625558, -0.031593, -0.035503},
    {-0.005252, -0.027748, -0.063957, 0.021237, 0.819369, 0.256351},
};
