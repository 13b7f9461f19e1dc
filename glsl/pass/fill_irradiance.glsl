#version 330 core
// The irradiance of the unblocked sky divided by pi, for each normal: the sum of the patches' radiance, weighted with their
// cosines. The sum is divided by the same sum for a sky of radiance 1. That would be pi if patches were infinitely small, and with
// it a uniform sky comes out exactly.
#include "light/irradiance.glsl"

uniform sampler2D patch_lights;
uniform sampler2D patch_directions;
uniform int patch_columns;
uniform int patch_rows;
uniform vec3 irradiance_size;

out vec4 irradiance;

void main() {
    vec2 texel = floor(gl_FragCoord.xy);
    vec3 normal = irradiance_normal(texel / (vec2(irradiance_size.x, irradiance_size.y) - 1.0));
    vec4 sum = vec4(0.0);
    int row = 0;
    do {
        int column = 0;
        do {
            vec4 light = texelFetch(patch_lights, ivec2(column, row), 0);
            vec3 direction = texelFetch(patch_directions, ivec2(column, row), 0).xyz;
            float level = normal.x * direction.x + normal.y * direction.y;
            float aside = normal.z * direction.z;
            // The patch on either side of the sun.
            sum += light * (max(level + aside, 0.0) + max(level - aside, 0.0));
            column += 1;
        } while (column < patch_columns);
        row += 1;
    } while (row < patch_rows);
    irradiance = vec4(sum.rgb / sum.a, 1.0);
}
