// The sums of the sky's light with a spectrum: coloured ones. Scattering coefficients are in them, because a colour mixes wavelengths whose coefficients
// differ. The phase functions are not, because they are the same for all wavelengths.
#include <sums>
#include "pass/spectrum_bands.glsl"

SkySums sky_light_sums(vec3 direction) {
    SkySums colored = SkySums(vec3(0.0), vec3(0.0));
    for (int band = 0; band < BANDS; band++) {
        Atmosphere air = band_air(band);
        SkySums sums = sky_sums(air, direction);
        colored.rayleigh += band_color(band, sums.rayleigh * air.rayleigh_scatter_per_m);
        colored.mie += band_color(band, sums.mie * air.mie_scatter_per_m);
    }
    return colored;
}
