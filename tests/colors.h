/* The colours of spectra, and how different they look. */
#pragma once

enum { COLORS_SAMPLES = 48 };

/* From 360 to 830 nm, every 10 nm. */
double colors_wavelength_nm(int i);

/* The sun's irradiance above the air there, W m^-2 nm^-1. */
double colors_sun_per_nm(int i);

/* The linear sRGB of radiances at these wavelengths, as shares of the sun's own above the air
 * (tests/data/spectral.csv).
 *
 * The spectrum is brought to XYZ by the colour matching functions of CIE 1931. Then it is adapted from the
 * sun's white to that of sRGB, by Bradford's matrix as colour profiles do, and scaled so that the sun itself
 * is exactly 1,1,1. */
void colors_of_shares(const double shares[COLORS_SAMPLES], double rgb[3]);

double colors_luminance(const double rgb[3]);

/* CIELAB for sRGB's white. */
void colors_lab(const double rgb[3], double lab[3]);

/* The colour difference CIEDE2000: 1 is about what an eye can just see. */
double colors_difference(const double lab[3], const double other[3]);

/* The same between two colours of linear sRGB that are scaled to the luminance 0.5, so that only their
 * chromaticities count. */
double colors_difference_of_hues(const double rgb[3], const double other[3]);
