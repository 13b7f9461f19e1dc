// --sky table: looks up the sums and applies the phase functions. The first half of the textures' rows is above the horizon.
#include "pass/sky_light.glsl"
#include "pass/sky_table_size.glsl"
#include <root>
#include "sky/table.glsl"

uniform sampler2D sky_table_rayleigh;
uniform sampler2D sky_table_mie;

vec3 sky_radiance(vec3 direction) {
    vec3 position = table_position(sky_horizon, sky_limb, direction, sun_level);
    vec2 texel = vec2(position.x * (sky_table_size.x - 1.0) + 0.5,
                      position.y * (sky_table_size.y - 1.0) + 0.5 + position.z * sky_table_size.y);
    vec2 at = texel / vec2(sky_table_size.x, 2.0 * sky_table_size.y);
    vec3 rayleigh = textureLod(sky_table_rayleigh, at, 0.0).rgb;
    vec3 mie = textureLod(sky_table_mie, at, 0.0).rgb;
    SkySums sums = SkySums(fourth_power(rayleigh), fourth_power(mie));
    return sky_light(sums, direction);
}
