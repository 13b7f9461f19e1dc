// The sums of the sky's light as colours (pass/sums_add_bands.glsl), with the further light. That is divided by the phase function of air, which is
// smooth and nowhere 0, and added to the air's sums: so it costs a look-up nothing.
#include <sums>
#include <further>

SkySums sky_light_sums(vec3 direction) {
    SkySums colored = sky_sums(atmosphere, direction);
    colored.rayleigh += further_light(direction) / rayleigh_phase(direction, sun_direction);
    return colored;
}
