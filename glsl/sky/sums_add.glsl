// Sums in the channels of an atmosphere.
#include "sky/sums.glsl"

void sky_sums_add(INOUT(SkySums) sums, Atmosphere a, float length, vec2 density, vec2 column, float absorber) {
    vec3 light = transmittance_of(a, column, absorber);
    light *= length;
    sums.rayleigh += light * density.x;
    sums.mie += light * density.y;
}
