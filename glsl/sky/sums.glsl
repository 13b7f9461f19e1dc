// The result of every sky method that integrates: single scattering summed along a ray, without the phase functions. The sums are smooth over the
// sky, so that a table can hold them.
#include "sky/atmosphere.glsl"
#include "sky/phase.glsl"

struct SkySums {
    // The integral of (transmittance from the sun to the point and on to the eye) * (density of air), in metres.
    vec3 rayleigh;
    // The same with the density of aerosols.
    vec3 mie;
};

vec3 sky_shade(Atmosphere a, SkySums sums, vec3 view, vec3 sun) {
    return a.sun_irradiance * (sums.rayleigh * a.rayleigh_scatter_per_m * rayleigh_phase(view, sun) +
                               sums.mie * a.mie_scatter_per_m * mie_phase(a.mie_g, view, sun));
}

// Returns the transmittance through columns of air and aerosols, and through a column of the absorber.
vec3 transmittance_of(Atmosphere a, vec2 column, float absorber) {
    return exp(-(a.rayleigh_scatter_per_m * column.x + a.mie_extinction_per_m * column.y +
                 a.ozone_absorb_per_m * absorber));
}

// Adds what is scattered on a length of the ray. The columns are those on the way from the sun and on to the eye.
void sky_sums_add(INOUT(SkySums) sums, Atmosphere a, float length, vec2 density, vec2 column, float absorber);
