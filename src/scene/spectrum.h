/* An air's colours from several wavelengths (atmosphere.spectrum).
 *
 * Three wavelengths at a time are computed as the three channels of a vec3: a band. The air at a band is an
 * Atmosphere again whose channels are those wavelengths, so that nothing else has to know of spectra. What is
 * computed for a sun of irradiance 1 at each wavelength is brought to linear sRGB by a 3x3 matrix for each
 * band: radiance = the sum over bands of matrix times channels. White is the sun above the air. */
#pragma once

#include "scene/atmosphere.h"

enum { MOST_BANDS = 2, MOST_WAVELENGTHS = 3 * MOST_BANDS };

/* 1 for rgb and for 3 wavelengths, 2 for 6. */
int spectrum_bands(const Atmosphere *atmosphere);

/* The air at the three wavelengths of a band, with the spectrum rgb. For rgb it is `atmosphere` itself. Else
 * its sun's irradiance is 1, as the matrix has the sun's. */
Atmosphere spectrum_band(const Atmosphere *atmosphere, int band);

/* Linear sRGB = the sum over bands of matrix times the band's channels. For rgb it is the identity. */
void spectrum_matrix(const Atmosphere *atmosphere, int band, double matrix[3][3]);

/* Adds a band's part, the matrix times its channels, to a radiance in linear sRGB. */
void spectrum_add(const Atmosphere *atmosphere, int band, const double channels[3], double rgb[3]);

/* Writes the wavelengths of atmosphere.spectrum, band after band, and returns their number: 0 for rgb. */
int spectrum_wavelengths(const Atmosphere *atmosphere, double wavelengths_nm[MOST_WAVELENGTHS]);

/* The air at any three wavelengths from 360 to 830 nm, in the order given, with the spectrum rgb and a sun of
 * irradiance 1.
 *
 * The settings' green values, at the second of `atmosphere->wavelengths_nm`, say how much air and aerosol
 * there is. Rayleigh scattering goes as (n^2 - 1)^2 / wavelength^4, where n is the refractive index of air
 * (Peck and Reeder 1972). Mie scattering goes as the wavelength to the power of -mie_angstrom. Ozone absorbs
 * by its measured cross-section, and `ozone` = 1 is 300 Dobson units in the tent of the settings' default.
 * The ground's albedo is linear in the wavelength between the settings' three, and constant beyond. */
Atmosphere spectrum_air_at(const Atmosphere *atmosphere, const double wavelengths_nm[3]);

/* Whether the settings' three channels follow the laws by which spectrum_air_at() computes all wavelengths.
 * An error of STATUS_USAGE names the setting that does not. All settings pass with the spectrum rgb. */
MUST_CHECK bool spectrum_check(const Atmosphere *atmosphere, Error *error);
