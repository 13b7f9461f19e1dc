#version 330 core
// All light of the sky but what the air scatters once, by direction: the further orders, and sunlight that the ground reflects. The table holds
// linear sRGB as fourth roots with their sign. The sun's irradiance is in it, as it is in band_color(). Each half is laid out as that of the sky's
// table.
#include <spectrum>

const int ORDER_BANDS = BANDS;
#include "pass/orders.glsl"
#include "pass/further_size.glsl"
#include "sky/root_signed.glsl"
#include "sky/table.glsl"

uniform sampler2D sky_moments;
uniform int sky_moments_degree;

out vec4 further;

void main() {
    vec2 texel = floor(gl_FragCoord.xy);
    float below = texel.x < further_size.z ? 0.0 : 1.0;
    texel.x -= below * further_size.z;
    further = vec4(0.0);
    if (texel.x >= further_size.x) return;
    vec3 view = table_direction(further_horizon, further_limb, further_position(texel, below), sun_level);
    int rows = int(2.0 * further_size.y + 0.5);
    OrderRay ray = order_ray(atmosphere, observer_height_m, view, sun_direction, ivec2(0, int(texel.y + below * further_size.y)));
    vec3 light[BANDS];
    order_gather(sky_moments, sky_moments_degree, sky_moments_degree, 0, atmosphere, ray, rows, light);
    float sine = order_end_sine(atmosphere, ray);
    vec3 color = vec3(0.0);
    for (int band = 0; band < BANDS; band++) {
        Atmosphere air = band_air(band);
        vec3 irradiance = order_sunlight(air, sine) + order_ground(sky_moments, sky_moments_degree, band, air, sine);
        color += band_color(band, light[band] + order_end_kept(ray, band * rows) * band_ground(band) / PI * irradiance);
    }
    further = vec4(fourth_root(color), 0.0);
}
