/* An air's colours from several wavelengths (atmosphere.spectrum).
 *
 * Three wavelengths at a time are computed as the three channels of a vec3: a band. The air at a band is an
 * Atmosphere again whose channels are those wavelengths, so that nothing else has to know of spectra. What is
 * computed for a sun of irradiance 1 at each wavelength is brought to linear sRGB by a 3x3 matrix for each
 * band: radiance = the sum over bands of matrix times channels. White is the sun above the air. */
#pragma once

#include "scene/atmosphere.h"

enum { MOST_BANDS = 2 };

/* 1 for rgb and for 3 wavelengths, 2 for 6. */
int spectrum_bands(const Atmosphere *atmosphere);

/* The air at the three wavelengths of a band, with the spectrum rgb. For rgb it is `atmosphere` itself. Else
 * its sun's irradiance is 1, as the matrix has the sun's. */
Atmosphere spectrum_band(const Atmosphere *atmosphere, int band);

/* Linear sRGB = the sum over bands of matrix times the band's channels. For rgb it is the identity. */
void spectrum_matrix(const Atmosphere *atmosphere, int band, double matrix[3][3]);
