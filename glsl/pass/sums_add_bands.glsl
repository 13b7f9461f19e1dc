// Coloured sums of all bands. Scattering coefficients are in them, because a colour mixes wavelengths whose coefficients differ. The phase functions
// are not, because they are the same for all wavelengths. What does not depend on the wavelength is computed once for all bands.
#include "sky/sums.glsl"
#include "pass/spectrum_bands.glsl"

void sky_sums_add(INOUT(SkySums) sums, Atmosphere a, float length, vec2 density, vec2 column, float absorber) {
    for (int band = 0; band < BANDS; band++) {
        Atmosphere air = band_air(band);
        vec3 light = length * transmittance_of(air, column, absorber);
        sums.rayleigh += density.x * band_color(band, light * air.rayleigh_scatter_per_m);
        sums.mie += density.y * band_color(band, light * air.mie_scatter_per_m);
    }
}
