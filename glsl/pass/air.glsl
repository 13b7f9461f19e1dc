// The atmosphere's air between the scene's surfaces (mist/air.glsl), and the sunlight in it.
#include "pass/atmosphere.glsl"
#include <spectrum>
#include <absorber>
#include "sky/column.glsl"
#include "sky/sums.glsl"
#include "mist/air.glsl"
#include "mist/sky_none.glsl"
// The constants AIR_SCATTERS_AGAIN and AIR_SUNLIT.
#include <air-light>

// The coefficients in the picture's channels.
uniform vec3 air_rayleigh_scatter_per_m;
uniform vec3 air_mie_scatter_per_m;
uniform vec3 air_mie_extinction_per_m;
uniform vec3 air_ozone_absorb_per_m;

Atmosphere air_here() {
    Atmosphere air = atmosphere;
    air.rayleigh_scatter_per_m = air_rayleigh_scatter_per_m;
    air.mie_scatter_per_m = air_mie_scatter_per_m;
    air.mie_extinction_per_m = air_mie_extinction_per_m;
    air.ozone_absorb_per_m = air_ozone_absorb_per_m;
    return air;
}

float air_base_m() {
    return observer_height_m;
}

bool air_scatters_again() {
    return AIR_SCATTERS_AGAIN;
}

vec3 air_sun_direction() {
    return sun_direction;
}

// The sun is a point, and its light is reddened by the air above the place, both as in the sky. With a spectrum the colour is that of the product of
// sunlight and scattering at each wavelength.
vec3 air_sunlight(vec3 position, vec3 incoming) {
    float h = max(air_altitude(position), 0.0);
    float b = (atmosphere.planet_radius_m + h) * sun_direction.y;
    vec2 column = columns_to_top(atmosphere, h, b, densities(atmosphere, h));
    float absorber = absorber_column_to_top(atmosphere, h, b);
    vec2 density = air_densities(atmosphere, air_altitude(position));
    vec3 light = vec3(0.0);
    for (int band = 0; band < BANDS; band++) {
        Atmosphere air = band_air(band);
        vec3 scattered = air.rayleigh_scatter_per_m * (density.x * rayleigh_phase(incoming, sun_direction)) +
                         air.mie_scatter_per_m * (density.y * mie_phase(air.mie_g, incoming, sun_direction));
        light += band_color(band, air.sun_irradiance * transmittance_of(air, column, absorber) * scattered);
    }
    return AIR_SUNLIT && !in_planet_shadow(atmosphere, h, b) ? light : vec3(0.0);
}
