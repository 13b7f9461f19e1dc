/* The atmosphere's numbers: presets as rows of data with their source, each value settable and checked.
 *
 * Errata of the source paper, "Global Illumination through Atmospheric Scattering" (Simmons 2017), which the
 * presets here do not repeat. Its text: beta_R for red is printed 5.8e-5 per metre (5.8e-6 is meant), beta_M
 * is printed 210e-5 (21e-6 is meant), the Rayleigh phase function lacks its 1/(4 pi), and one H0 stands for
 * both gases and is called a density (it is a scale height, 7994 m for air and 1200 m for aerosols). Its
 * program: light is scattered by the Mie extinction in place of the Mie scattering, 1.1 times too much, and
 * sunlight that meets the planet is attenuated up to the ground in place of being blocked. */
#pragma once

#include "base/error.h"
#include "base/text.h"

#include <stddef.h>

/* SI units; [3] is at the wavelengths of R, G, B. The field table in atmosphere.c holds ranges and
 * descriptions. */
typedef struct Atmosphere {
    double planet_radius_m;
    double top_radius_m; /* density is 0 above */
    double rayleigh_scale_height_m, mie_scale_height_m;
    double rayleigh_scatter_per_m[3]; /* at height 0; Rayleigh extinction is the same */
    double mie_scatter_per_m[3];      /* at height 0 */
    double mie_extinction_ratio;      /* extinction / scattering */
    double mie_g;                     /* Cornette-Shanks asymmetry */
    double rayleigh, mie;             /* multiply the densities; 0 leaves the term out */
    double ozone;                     /* multiplies the density of the absorbing layer; 0 leaves it out */
    double ozone_absorb_per_m[3];     /* at the layer's middle; it scatters nothing */
    double ozone_height_m;            /* of the layer's middle, where its density is 1 */
    double ozone_half_width_m;        /* over which that falls to 0, upward and downward, linearly */
    double sun_irradiance[3];         /* above the atmosphere, on a surface that faces the sun */
    double wavelengths_nm[3];
    double refractive_index;  /* of air at height 0, for Rayleigh coefficients from the formula */
    double molecules_per_m3;  /* of air at height 0, likewise */
    double observer_height_m; /* of all rays that escape a scene */
    /* How many times light may be scattered, by the air or the ground, until it is seen: 1, 2, ...; INFINITY
     * for all orders. */
    double orders;
    double ground_albedo[3]; /* of the planet, which is matte */
    /* How colours are computed: SPECTRUM_RGB, or a number of wavelengths (scene/spectrum.h). */
    double spectrum;
    /* With a spectrum: Mie scattering goes as the wavelength to the power of minus this. */
    double mie_angstrom;
} Atmosphere;

/* The three channels of the settings are computed as they are. */
#define SPECTRUM_RGB 0

typedef struct AtmospherePreset {
    const char *name, *source;
    Atmosphere atmosphere;
} AtmospherePreset;

/* A value that is written as a word. */
typedef struct AtmosphereWord {
    const char *word;
    double value;
} AtmosphereWord;

enum { ATMOSPHERE_WORDS = 3 };

typedef struct AtmosphereField {
    const char *name;    /* as in "atmosphere.NAME" */
    const char *setting; /* that in full */
    size_t offset;       /* of a double or a double[3] in Atmosphere */
    int count;           /* 1 or 3 */
    /* Of numbers. Where max is below min, only the words are values. */
    double min, max;
    const char *description;
    bool whole; /* whether only whole numbers are values */
    AtmosphereWord words[ATMOSPHERE_WORDS];
} AtmosphereField;

/* The rows; NULL past the end. Index 0 is the default preset. */
const AtmospherePreset *atmosphere_preset(int index);
const AtmosphereField *atmosphere_field(int index);
const double *atmosphere_value(const Atmosphere *atmosphere, const AtmosphereField *field);

/* Whether two atmospheres have the same value of a field. */
bool atmosphere_same(const Atmosphere *a, const Atmosphere *b, const AtmosphereField *field);

/* Appends the value as it is set ("5.8e-06,1.35e-05,3.31e-05", "all"), and what may be set ("1 to 1000, or
 * all"). */
void atmosphere_print_value(const Atmosphere *atmosphere, const AtmosphereField *field, Text *out);
void atmosphere_print_range(const AtmosphereField *field, Text *out);

/* Overwrites all values with a preset's. STATUS_USAGE names the known presets. */
MUST_CHECK bool atmosphere_choose(Atmosphere *atmosphere, const char *preset, Error *error);

/* Sets "mie_g" to "0.8" or "rayleigh_scatter_per_m" to "5.8e-6,13.5e-6,33.1e-6" (one number sets all three).
 * Setting the wavelengths, the refractive index or the molecules computes the Rayleigh coefficients anew. */
MUST_CHECK bool atmosphere_set(Atmosphere *atmosphere, const char *name, const char *value, Error *error);

/* What no single value shows: the top above the planet. */
MUST_CHECK bool atmosphere_check(const Atmosphere *atmosphere, Error *error);

/* The paper's formula, 8 pi^3 (n^2 - 1)^2 / (3 N lambda^4), per metre. */
double atmosphere_rayleigh_formula(double refractive_index, double molecules_per_m3, double wavelength_m);
