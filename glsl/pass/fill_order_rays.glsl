#version 330 core
// The rays along which the field of an order is gathered (pass/rays.glsl). Across stands the ray of one elevation after the other, with all of its
// nodes. Along stands one altitude of the grid after the other, band by band.
#include "pass/rays.glsl"
#include "pass/order_directions.glsl"

uniform OrderGrid ray_grid;

layout(location = 0) out vec4 by_air;
layout(location = 1) out vec4 by_aerosols;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int rows = int(ray_grid.rows + 0.5);
    int texels = 2 * ray_nodes + 1;
    Atmosphere air = band_air(texel.y / rows);
    float h = order_altitude(ray_grid, air.thickness_m, float(texel.y % rows));
    ray_texel(air, h, order_elevation_sine(air.planet_radius_m, h, texel.x / texels), texel.x % texels, by_air, by_aerosols);
}
