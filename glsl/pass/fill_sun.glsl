#version 330 core
// Fills the table of the sun's radiances (pass/sun_disk.glsl) where no host computes it, as src/sky/sun_disk.c does by quadrature. Columns in closed
// form differ from that by 3e-5 of the radiance at most, with the sun on the horizon.
#include "sky/column.glsl"
#include "sky/sums.glsl"
#include "pass/sun_disk.glsl"
#include <spectrum>
#include <absorber>

layout(location = 0) out vec4 radiance;

vec3 radiance_at(float height) {
    float h = observer_height_m;
    float b = (atmosphere.planet_radius_m + h) * height;
    vec2 column = columns_to_top(atmosphere, h, b, densities(atmosphere, h));
    float absorber = absorber_column_to_top(atmosphere, h, b);
    // Pi times the squared sine of the disk's radius.
    float solid_angle = PI * sun_disk_one_less_cos * (2.0 - sun_disk_one_less_cos);
    vec3 sum = vec3(0.0);
    for (int band = 0; band < BANDS; band++) {
        Atmosphere air = band_air(band);
        sum += band_color(band, air.sun_irradiance * transmittance_of(air, column, absorber)) / solid_angle;
    }
    return sum;
}

void main() {
    // The lowest value lies slightly above the horizon, where rounding would decide whether the planet blocks the light.
    float at = max(floor(gl_FragCoord.x), 0.01) / 255.0;
    bool visible = sun_disk_heights.y > sun_disk_heights.x;
    float height = mix(sun_disk_heights.x, sun_disk_heights.y, at * at);
    radiance = vec4(visible ? radiance_at(height) : vec3(0.0), 1.0);
}
