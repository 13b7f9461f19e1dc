#version 330 core
// The ground's light by direction, for an air of one order: sunlight that the ground reflects, and nothing else. It is laid out and held as in
// pass/fill_further.glsl.
const int ORDER_BANDS = 1;
#include "pass/orders.glsl"
#include "pass/further_size.glsl"
#include "sky/root_signed.glsl"
#include "sky/table.glsl"

out vec4 further;

void main() {
    vec2 texel = floor(gl_FragCoord.xy);
    float below = texel.x < further_size.z ? 0.0 : 1.0;
    texel.x -= below * further_size.z;
    further = vec4(0.0);
    if (texel.x >= further_size.x) return;
    vec3 view = table_direction(further_horizon, further_limb, further_position(texel, below), sun_level);
    vec3 color = vec3(0.0);
    int band = 0;
    do {
        Atmosphere air = band_air(band);
        OrderRay ray = order_ray(air, observer_height_m, view, sun_direction, ivec2(0, int(texel.y + (below + 2.0 * float(band)) * further_size.y)));
        color += band_color(band, order_end_kept(ray, 0) * band_ground(band) / PI * order_sunlight(air, order_end_sine(air, ray)));
        band += 1;
    } while (band < BANDS);
    further = vec4(fourth_root(color), 0.0);
}
