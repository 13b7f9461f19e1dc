#version 330 core
// Fills the sky's table by a direct method. The centres of the outer texels are on the edges of the unit square.
#include <light-sums>
#include "pass/sky_table_size.glsl"
#include <root>
#include "sky/table.glsl"

layout(location = 0) out vec4 rayleigh;
layout(location = 1) out vec4 mie;

void main() {
    vec2 texel = floor(gl_FragCoord.xy);
    float below = texel.y >= sky_table_size.y ? 1.0 : 0.0;
    vec3 position = vec3(texel.x / (sky_table_size.x - 1.0), (texel.y - below * sky_table_size.y) / (sky_table_size.y - 1.0), below);
    SkySums sums = sky_light_sums(table_direction(sky_horizon, sky_limb, position, sun_level));
    rayleigh = vec4(fourth_root(sums.rayleigh), 0.0);
    mie = vec4(fourth_root(sums.mie), 0.0);
}
