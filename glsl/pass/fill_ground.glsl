#version 330 core
// The ground's light by direction where there is one order: sunlight that the ground scattered, and nothing else. The table is laid out as the sky's, and holds linear
// sRGB as fourth roots with their sign.
#include "pass/orders.glsl"
#include "pass/further_size.glsl"
#include "sky/root_signed.glsl"
#include "sky/table.glsl"

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
        OrderEnd end = order_end(air, observer_height_m, view, sun_direction, order_columns(air, observer_height_m, view));
        color += band_color(band, end.kept * band_ground(band) / PI * order_sunlight(air, end.sine));
        band += 1;
    } while (band < BANDS);
    further = vec4(fourth_root(color), 0.0);
}
