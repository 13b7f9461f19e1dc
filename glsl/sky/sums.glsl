// What every sky method that integrates gives: single scattering summed along a ray, without the phase functions, so that
// it is smooth over the sky and a table can hold it.
#include "sky/atmosphere.glsl"
#include "sky/phase.glsl"

struct SkySums {
    vec3 rayleigh; // integral of transmittance (eye to point to sun) times the density of air, m
    vec3 mie;      // the same with the density of aerosols
};

vec3 sky_shade(Atmosphere a, SkySums sums, vec3 view, vec3 sun) {
    return a.sun_irradiance * (sums.rayleigh * a.rayleigh_scatter_per_m * rayleigh_phase(view, sun) +
                               sums.mie * a.mie_scatter_per_m * mie_phase(a.mie_g, view, sun));
}

// Transmittance through columns of air and aerosols and a column of the absorber.
vec3 transmittance_of(Atmosphere a, vec2 column, float absorber) {
    return exp(-(a.rayleigh_scatter_per_m * column.x + a.mie_extinction_per_m * column.y +
                 a.ozone_absorb_per_m * absorber));
}
