/* Real spherical harmonics about the direction of the sun, and phase functions as sums of Legendre
 * polynomials: what the further orders of scattering are made of (glsl/sky/README.md).
 *
 * A harmonic has a degree l and a number m of turns about the axis, from 0 to l. Only harmonics that are even
 * in the azimuth are needed, because the light is the same on both sides of the sun. Those up to a degree are
 * numbered by m first and by l within it: (m,l) = (0,0), (0,1) ... (0,most), (1,1), (1,2) ... */
#pragma once

enum {
    HARMONICS_MOST_DEGREE = 24,
    HARMONICS_MOST = (HARMONICS_MOST_DEGREE + 1) * (HARMONICS_MOST_DEGREE + 2) / 2
};

/* The number of harmonics up to a degree. */
int harmonics_count(int most);

/* The number of the harmonic with m turns and degree l among those up to the degree `most`. */
int harmonics_index(int most, int l, int m);

/* The recurrence Y(l,m) = rise (nu Y(l-1,m) - fall Y(l-2,m)) of the normalised Legendre functions of nu, for
 * l > m. For l = m > 0, Y(m,m) = rise sqrt(1 - nu^2) Y(m-1,m-1). Y(0,0) = rise. */
typedef struct HarmonicStep {
    double rise, fall;
} HarmonicStep;

HarmonicStep harmonics_step(int l, int m);

/* The steps of all harmonics up to a degree, one for each harmonic. */
void harmonics_steps(int most, HarmonicStep *steps);

/* All harmonics up to a degree in the direction whose cosine to the axis is `nu` and whose azimuth has the
 * cosine `cos_psi`. They are orthonormal over the sphere. `steps` are those of the same degree. */
void harmonics_at(const HarmonicStep *steps, int most, double nu, double cos_psi, double *values);

/* The cosine of that azimuth, counted from the zenith. `mu` and `mu_sun` are the sines of elevation of the
 * direction and of the sun. Where the direction or the sun is no axis of a turn it is between -1 and 1. */
double harmonics_azimuth(double mu, double mu_sun, double nu);

/* The Legendre coefficients 0 to `most` of the phase function of Cornette and Shanks: chi_l is the integral
 * of P_l(nu) p(nu) over the sphere, so that chi_0 is 1. Accurate to 1e-9. */
void harmonics_mie(double g, int most, double *chi);
