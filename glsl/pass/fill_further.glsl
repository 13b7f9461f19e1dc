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
    vec3 view = table_direction(further_horizon, further_limb, further_position(texel), sun_level);
    vec3 color = vec3(0.0);
    int band = 0;
    do {
        Atmosphere air = band_air(band);
        OrderRay ray = order_ray(air, observer_height_m, view, sun_direction, ivec2(0, int(texel.y) + band * int(2.0 * further_size.y + 0.5)));
        vec3 light = order_gather(sky_moments, sky_moments_degree, sky_moments_degree, band, air, ray);
        float sine = order_end_sine(air, ray);
        vec3 irradiance = order_sunlight(air, sine) + order_ground(sky_moments, sky_moments_degree, band, air, sine);
        color += band_color(band, light + order_end_kept(ray) * band_ground(band) / PI * irradiance);
        band += 1;
    } while (band < BANDS);
    further = vec4(fourth_root(color), 0.0);
}
