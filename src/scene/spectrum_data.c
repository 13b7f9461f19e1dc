#include "scene/spectrum_data.h"

#include <math.h>

enum { SAMPLES = 48 };

static const double step_nm = 10;

/* 300 Dobson units are 8.061e22 molecules above each square metre. The tent's area is 15 km times its peak.
 */
static const double ozone_molecules_per_m3 = 5.374e18;

/* One row for each wavelength from 360 nm on, every 10 nm. Both are means over 10 nm.
 *
 * The sun: ASTM G-173, the extraterrestrial spectrum, W m^-2 nm^-1. Ozone: its absorption cross-section at
 * 233 K, m^2 (University of Bremen, O3 spectra 2011). */
static const struct {
    double sun_per_nm, ozone_m2;
} samples[SAMPLES] = {
    {1.11776, 1.18e-27},  {1.14259, 2.182e-28}, {1.01249, 2.818e-28}, {1.14716, 6.636e-28},
    {1.72765, 1.527e-27}, {1.73054, 2.763e-27}, {1.6887, 5.52e-27},   {1.61253, 8.451e-27},
    {1.91198, 1.582e-26}, {2.03474, 2.316e-26}, {2.02042, 3.669e-26}, {2.02212, 4.924e-26},
    {1.93377, 7.752e-26}, {1.95809, 9.016e-26}, {1.91686, 1.48e-25},  {1.8298, 1.602e-25},
    {1.8685, 2.139e-25},  {1.8931, 2.755e-25},  {1.85149, 3.091e-25}, {1.8504, 3.5e-25},
    {1.8341, 4.266e-25},  {1.8345, 4.672e-25},  {1.8147, 4.398e-25},  {1.78158, 4.701e-25},
    {1.7533, 5.019e-25},  {1.6965, 4.305e-25},  {1.68194, 3.74e-25},  {1.64654, 3.215e-25},
    {1.6048, 2.662e-25},  {1.52143, 2.238e-25}, {1.55622, 1.852e-25}, {1.5113, 1.473e-25},
    {1.474, 1.209e-25},   {1.4482, 9.423e-26},  {1.41018, 7.455e-26}, {1.36775, 6.566e-26},
    {1.34188, 5.105e-26}, {1.31429, 4.15e-26},  {1.28303, 4.228e-26}, {1.26758, 3.237e-26},
    {1.2367, 2.451e-26},  {1.2082, 2.801e-26},  {1.18737, 2.534e-26}, {1.14683, 1.624e-26},
    {1.12362, 1.465e-26}, {1.1058, 2.078e-26},  {1.07124, 1.383e-26}, {1.04992, 7.105e-27},
};

/* The place of a wavelength among the samples: the one below it, and the share of the next one. */
static int locate(double wavelength_nm, double *share) {
    double place = (wavelength_nm - SPECTRUM_SHORTEST_NM) / step_nm;
    int below = (int)fmin(fmax(floor(place), 0), SAMPLES - 2);
    *share = fmin(fmax(place - below, 0), 1);
    return below;
}

double spectrum_sun_per_nm(double wavelength_nm) {
    double share;
    int i = locate(wavelength_nm, &share);
    return (1 - share) * samples[i].sun_per_nm + share * samples[i + 1].sun_per_nm;
}

double spectrum_ozone_per_m(double wavelength_nm) {
    double share;
    int i = locate(wavelength_nm, &share);
    return ozone_molecules_per_m3 * ((1 - share) * samples[i].ozone_m2 + share * samples[i + 1].ozone_m2);
}
