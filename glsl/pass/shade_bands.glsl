// The radiance that coloured sums make (pass/light_sums_bands.glsl).
#include "pass/atmosphere.glsl"
#include "sky/sums.glsl"

vec3 sky_sums_radiance(SkySums sums, vec3 direction) {
    return sums.rayleigh * rayleigh_phase(direction, sun_direction) +
           sums.mie * mie_phase(atmosphere.mie_g, direction, sun_direction);
}
