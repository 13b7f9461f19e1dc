#version 330 core
// The observer's rays (pass/rays.glsl), one for each row of the table of the further light: first those above the horizon, then those below, band by
// band.
#include "pass/rays.glsl"
#include "pass/further_size.glsl"
#include "sky/root_signed.glsl"
#include "sky/table.glsl"

layout(location = 0) out vec4 by_air;
layout(location = 1) out vec4 by_aerosols;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int half_rows = int(further_size.y + 0.5);
    int rows = 2 * half_rows;
    int row = texel.y % rows;
    vec3 position = further_position(vec2(0.0, float(row % half_rows)), row < half_rows ? 0.0 : 1.0);
    vec3 view = table_direction(further_horizon, further_limb, position, vec3(1.0, 0.0, 0.0));
    ray_texel(band_air(texel.y / rows), observer_height_m, view.y, texel.x, by_air, by_aerosols);
}
