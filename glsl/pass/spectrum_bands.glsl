// Colours from several wavelengths (src/scene/spectrum.h). A band is three wavelengths, which are computed as the channels of a vec3. The sun's
// irradiance is 1 at each wavelength, because the matrix has the sun's colour.
#include "pass/atmosphere.glsl"
// The constant BANDS.
#include <bands>

uniform vec3 band_rayleigh_scatter_per_m[BANDS];
uniform vec3 band_mie_scatter_per_m[BANDS];
uniform vec3 band_mie_extinction_per_m[BANDS];
uniform vec3 band_ozone_absorb_per_m[BANDS];
uniform vec3 band_ground_albedo[BANDS];
// The rows of each band's matrix to linear sRGB.
uniform vec3 band_to_red[BANDS];
uniform vec3 band_to_green[BANDS];
uniform vec3 band_to_blue[BANDS];

Atmosphere band_air(int band) {
    Atmosphere air = atmosphere;
    air.rayleigh_scatter_per_m = band_rayleigh_scatter_per_m[band];
    air.mie_scatter_per_m = band_mie_scatter_per_m[band];
    air.mie_extinction_per_m = band_mie_extinction_per_m[band];
    air.ozone_absorb_per_m = band_ozone_absorb_per_m[band];
    air.sun_irradiance = vec3(1.0);
    return air;
}

vec3 band_ground(int band) {
    return band_ground_albedo[band];
}

// The linear sRGB of radiances in the band's channels. The colours of all bands are added.
vec3 band_color(int band, vec3 light) {
    return vec3(dot(band_to_red[band], light), dot(band_to_green[band], light), dot(band_to_blue[band], light));
}
