// Samples directions above the horizontal in proportion to the sky's luminance. The sky's cells are cut into bins of equal
// probability, in the order of Hilbert's curve over the sky. So numbers that are evenly spread give directions that are evenly
// spread.
#include "light/sky_cells.glsl"
#include "pass/sun.glsl"

// For each bin its cell, that cell's first bin, and the number of the cell's bins.
uniform sampler2D sky_bins;
// For each cell its share of the bins.
uniform sampler2D sky_cell_share;
uniform vec3 sky_cells_count;
uniform float sky_cells_horizon;

SkyCells sky_cells() {
    return SkyCells(sky_cells_count, sky_cells_horizon, sun_level);
}

// u.x chooses the side of the sun, the bin, and the azimuth in its cell. u.y chooses the elevation in the cell.
vec3 sky_sample(vec2 u) {
    ivec2 size = textureSize(sky_bins, 0);
    float bins = float(size.x * size.y);
    float side = u.x < 0.5 ? 1.0 : -1.0;
    float twice = 2.0 * u.x;
    float rest = twice - 1.0;
    float at = (u.x < 0.5 ? twice : rest) * bins;
    int bin = min(int(at), size.x * size.y - 1);
    vec4 entry = texelFetch(sky_bins, ivec2(bin % size.x, bin / size.x), 0);
    float across = clamp((at - entry.y) / entry.z, 0.0, 1.0);
    float row = floor((entry.x + 0.5) / sky_cells_count.x);
    return sky_cell_sample(sky_cells(), vec2(entry.x - row * sky_cells_count.x, row), vec2(across, u.y), side);
}

// The density of sky_sample() at a direction, 1/sr.
float sky_pdf(vec3 direction) {
    SkyCells cells = sky_cells();
    vec2 cell = floor(sky_cell_position(cells, direction));
    float share = texelFetch(sky_cell_share, ivec2(int(cell.x), int(cell.y)), 0).x;
    return share / sky_cell_solid_angle(cells, cell.y);
}
