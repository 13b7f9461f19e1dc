// The sums of the sky's light with a spectrum: coloured ones. Scattering coefficients are in them, because a colour mixes wavelengths whose coefficients
// differ. The phase functions are not, because they are the same for all wavelengths.
// The further light is divided by the phase function of air, which is smooth and nowhere 0, and added to the air's sums: so it costs a look-up nothing.
#include <sums>
#include <further>
#include "pass/spectrum_bands.glsl"

SkySums sky_light_sums(vec3 direction) {
    SkySums colored = SkySums(vec3(0.0), vec3(0.0));
    for (int band = 0; band < BANDS; band++) {
        Atmosphere air = band_air(band);
        SkySums sums = sky_sums(air, direction);
        colored.rayleigh += band_color(band, sums.rayleigh * air.rayleigh_scatter_per_m);
        colored.mie += band_color(band, sums.mie * air.mie_scatter_per_m);
    }
    colored.rayleigh += further_light(direction) / rayleigh_phase(direction, sun_direction);
    return colored;
}
