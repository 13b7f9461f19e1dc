// The light of the further orders and of the ground, from a table (pass/fill_further.glsl).
#include "pass/sun.glsl"
#include "pass/further_size.glsl"
#include "sky/root_signed.glsl"
#include "sky/table.glsl"

uniform sampler2D further_table;

vec3 further_light(vec3 direction) {
    vec3 position = table_position(further_horizon, further_limb, direction, sun_level);
    vec2 texel = vec2(position.x * (further_size.x - 1.0) + 0.5 + position.z * further_size.z, position.y * (further_size.y - 1.0) + 0.5);
    vec2 size = vec2(further_size.z + further_size.x, further_size.y);
    return fourth_power(textureLod(further_table, texel / size, 0.0).rgb);
}
