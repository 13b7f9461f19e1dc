#version 330 core
// The light beyond the first order and the ground's, by direction: linear sRGB, as fourth roots with their sign. The table is laid out as the sky's.
#include "pass/orders.glsl"
#include "pass/further_size.glsl"
#include "sky/root_signed.glsl"
#include "sky/table.glsl"

uniform sampler2D sky_moments;
uniform int sky_moments_degree;

out vec4 further;

void main() {
    vec2 texel = floor(gl_FragCoord.xy);
    float below = texel.y >= further_size.y ? 1.0 : 0.0;
    vec3 position = vec3(texel.x / (further_size.x - 1.0), (texel.y - below * further_size.y) / (further_size.y - 1.0), below);
    vec3 view = table_direction(further_horizon, further_limb, position, sun_level);
    vec3 color = vec3(0.0);
    int band = 0;
    do {
        Atmosphere air = band_air(band);
        vec2 column;
        vec3 light = order_gather(sky_moments, sky_moments_degree, sky_moments_degree, band, air, observer_height_m, view, sun_direction, column);
        OrderEnd end = order_end(air, observer_height_m, view, sun_direction, column);
        vec3 irradiance = order_sunlight(air, end.sine) + order_ground(sky_moments, sky_moments_degree, band, air, end.sine);
        color += band_color(band, light + end.kept * band_ground(band) / PI * irradiance);
        band += 1;
    } while (band < BANDS);
    further = vec4(fourth_root(color), 0.0);
}
