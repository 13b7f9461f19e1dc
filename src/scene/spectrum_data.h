/* Measured spectra from 360 to 830 nm. Between their values, 10 nm apart, they are linear. */
#pragma once

#define SPECTRUM_SHORTEST_NM 360.0
#define SPECTRUM_LONGEST_NM 830.0

/* The sun's irradiance above the air on a surface that faces it, W m^-2 nm^-1. */
double spectrum_sun_per_nm(double wavelength_nm);

/* The absorption at the peak of a tent of ozone, 25 km +- 15 km, that holds 300 Dobson units, 1/m. */
double spectrum_ozone_per_m(double wavelength_nm);
