#include "scene/spectrum.h"

#include "scene/spectrum_data.h"
#include "scene/spectrum_figures.h"

#include <math.h>

enum { GREEN = 1 };

/* How far a channel of the settings may be from the law of its spectrum. */
static const double most_off = 0.05;

int spectrum_bands(const Atmosphere *atmosphere) {
    return atmosphere->spectrum > SPECTRUM_FEW ? SPECTRUM_MANY / 3 : 1;
}

int spectrum_wavelengths(const Atmosphere *atmosphere, double wavelengths_nm[MOST_WAVELENGTHS]) {
    if (atmosphere->spectrum == SPECTRUM_RGB) return 0;
    int count = 3 * spectrum_bands(atmosphere);
    for (int i = 0; i < count; i++)
        wavelengths_nm[i] = count == SPECTRUM_FEW ? spectrum_few_nm[i] : spectrum_many_nm[i];
    return count;
}

Atmosphere spectrum_band(const Atmosphere *atmosphere, int band) {
    double wavelengths_nm[MOST_WAVELENGTHS];
    if (!spectrum_wavelengths(atmosphere, wavelengths_nm)) return *atmosphere;
    return spectrum_air_at(atmosphere, wavelengths_nm + 3 * band);
}

void spectrum_matrix(const Atmosphere *atmosphere, int band, double matrix[3][3]) {
    bool rgb = atmosphere->spectrum == SPECTRUM_RGB, few = spectrum_bands(atmosphere) == 1;
    for (int row = 0; row < 3; row++) {
        for (int i = 0; i < 3; i++) {
            double fitted = few ? spectrum_few[row][i] : spectrum_many[row][3 * band + i];
            matrix[row][i] = rgb ? row == i : fitted * atmosphere->sun_irradiance[row];
        }
    }
}

void spectrum_add(const Atmosphere *atmosphere, int band, const double channels[3], double rgb[3]) {
    double matrix[3][3];
    spectrum_matrix(atmosphere, band, matrix);
    for (int row = 0; row < 3; row++) {
        for (int i = 0; i < 3; i++) rgb[row] += matrix[row][i] * channels[i];
    }
}

/* The refractive index of air at 15 degrees and 1013.25 hPa, less 1 (Peck and Reeder 1972). */
static double refractivity(double wavelength_nm) {
    double squared = 1e6 / (wavelength_nm * wavelength_nm);
    return 1e-8 * (8060.51 + 2480990 / (132.274 - squared) + 17455.7 / (39.32957 - squared));
}

/* Rayleigh scattering at a wavelength, over that at another. */
static double rayleigh_ratio(double wavelength_nm, double other_nm) {
    double n = 1 + refractivity(wavelength_nm), m = 1 + refractivity(other_nm);
    return pow((n * n - 1) / (m * m - 1), 2) * pow(other_nm / wavelength_nm, 4);
}

/* The settings' wavelengths fall from R to B. */
static double albedo_at(const Atmosphere *a, double wavelength_nm) {
    const double *nm = a->wavelengths_nm, *albedo = a->ground_albedo;
    int i = wavelength_nm > nm[GREEN] ? 0 : GREEN;
    double share = fmin(fmax((nm[i] - wavelength_nm) / (nm[i] - nm[i + 1]), 0), 1);
    return (1 - share) * albedo[i] + share * albedo[i + 1];
}

Atmosphere spectrum_air_at(const Atmosphere *atmosphere, const double wavelengths_nm[3]) {
    Atmosphere air = *atmosphere;
    double green_nm = atmosphere->wavelengths_nm[GREEN];
    air.spectrum = SPECTRUM_RGB;
    for (int i = 0; i < 3; i++) {
        double nm = wavelengths_nm[i];
        air.wavelengths_nm[i] = nm;
        air.rayleigh_scatter_per_m[i] =
            atmosphere->rayleigh_scatter_per_m[GREEN] * rayleigh_ratio(nm, green_nm);
        air.mie_scatter_per_m[i] =
            atmosphere->mie_scatter_per_m[GREEN] * pow(nm / green_nm, -atmosphere->mie_angstrom);
        air.ozone_absorb_per_m[i] = spectrum_ozone_per_m(nm);
        air.ground_albedo[i] = albedo_at(atmosphere, nm);
        air.sun_irradiance[i] = 1;
    }
    return air;
}

/* `law` says what the values have to follow. */
static bool check_values(const char *name, const double values[3], const double expected[3], const char *law,
                         Error *error) {
    for (int c = 0; c < 3; c++) {
        if (fabs(values[c] - expected[c]) <= most_off * expected[c]) continue;
        return error_set(error, STATUS_USAGE,
                         "a spectrum needs atmosphere.%s within %g %% of %.4g,%.4g,%.4g, which %s; for "
                         "%.4g,%.4g,%.4g use atmosphere.spectrum=rgb",
                         name, 100 * most_off, expected[0], expected[1], expected[2], law, values[0],
                         values[1], values[2]);
    }
    return true;
}

static bool check_wavelengths(const Atmosphere *atmosphere, Error *error) {
    const double *nm = atmosphere->wavelengths_nm;
    if (nm[0] <= SPECTRUM_LONGEST_NM && nm[0] > nm[1] && nm[1] > nm[2] && nm[2] >= SPECTRUM_SHORTEST_NM)
        return true;
    return error_set(error, STATUS_USAGE,
                     "a spectrum needs atmosphere.wavelengths_nm that fall from R to B, from %g to "
                     "%g; for %.9g,%.9g,%.9g use atmosphere.spectrum=rgb",
                     SPECTRUM_LONGEST_NM, SPECTRUM_SHORTEST_NM, nm[0], nm[1], nm[2]);
}

bool spectrum_check(const Atmosphere *atmosphere, Error *error) {
    if (atmosphere->spectrum == SPECTRUM_RGB) return true;
    if (!check_wavelengths(atmosphere, error)) return false;
    Atmosphere air = spectrum_air_at(atmosphere, atmosphere->wavelengths_nm);
    return (atmosphere->rayleigh == 0 ||
            check_values("rayleigh_scatter_per_m", atmosphere->rayleigh_scatter_per_m,
                         air.rayleigh_scatter_per_m, "follow from the green value for air", error)) &&
           (atmosphere->mie == 0 ||
            check_values("mie_scatter_per_m", atmosphere->mie_scatter_per_m, air.mie_scatter_per_m,
                         "follow from the green value and atmosphere.mie_angstrom", error)) &&
           (atmosphere->ozone == 0 ||
            check_values("ozone_absorb_per_m", atmosphere->ozone_absorb_per_m, air.ozone_absorb_per_m,
                         "are ozone's at atmosphere.wavelengths_nm (atmosphere.ozone multiplies them)",
                         error));
}
