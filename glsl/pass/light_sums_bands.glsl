// The sums of the sky's light with a spectrum: coloured ones. Scattering coefficients are in them, because a colour mixes wavelengths whose coefficients
// differ. The phase functions are not, because they are the same for all wavelengths.
// The further light is divided by the phase function of air, which is smooth and nowhere 0, and added to the air's sums: so it costs a look-up nothing.
#include <sums>
#include <further>
#include "pass/spectrum_bands.glsl"

SkySums band_sums(int band, vec3 direction) {
    Atmosphere air = band_air(band);
    SkySums sums = sky_sums(air, direction);
    return SkySums(band_color(band, sums.rayleigh * air.rayleigh_scatter_per_m),
                   band_color(band, sums.mie * air.mie_scatter_per_m));
}

// A loop over the bands would take 1.7 times as long with Mesa's software driver.
SkySums sky_light_sums(vec3 direction) {
    SkySums colored = band_sums(0, direction);
    if (BANDS > 1) {
        SkySums second = band_sums(BANDS - 1, direction);
        colored.rayleigh += second.rayleigh;
        colored.mie += second.mie;
    }
    colored.rayleigh += further_light(direction) / rayleigh_phase(direction, sun_direction);
    return colored;
}
