// The settings' three channels are the colours: there is one band, and it needs no matrix.
#include "pass/atmosphere.glsl"

// The planet's albedo.
uniform vec3 ground_albedo;

const int BANDS = 1;

Atmosphere band_air(int band) {
    return atmosphere;
}

vec3 band_ground(int band) {
    return ground_albedo;
}

// The linear sRGB of radiances in the band's channels.
vec3 band_color(int band, vec3 light) {
    return light;
}
