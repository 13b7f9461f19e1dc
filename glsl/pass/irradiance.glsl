// The unblocked sky's irradiance divided by pi on a surface that faces `normal`, from a table.
#include "light/irradiance.glsl"
#include "pass/sun.glsl"

uniform sampler2D irradiance_table;
uniform vec3 irradiance_size;

vec3 sky_irradiance_over_pi(vec3 normal) {
    vec2 position = irradiance_position(normal, sun_level);
    vec2 size = vec2(irradiance_size.x, irradiance_size.y);
    return textureLod(irradiance_table, (position * (size - 1.0) + 0.5) / size, 0.0).rgb;
}
