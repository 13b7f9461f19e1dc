// The sky's directions as a grid of cells, the one that pass/fill_radiance.glsl fills: across, azimuth from the sun's on either side
// of it; along, the sine of elevation, rows crowded at the visible horizon, those above it first.
#include "math/dialect.glsl"

struct SkyCells {
    vec3 count; // across, along above the horizon, along below it
    float horizon;
    vec3 level; // toward the sun's azimuth
};

// Where a direction lies: the cell by whole numbers, the place in it by the rest.
vec2 sky_cell_position(SkyCells cells, vec3 direction) {
    bool below = direction.y < cells.horizon;
    float reach = (below ? -1.0 : 1.0) - cells.horizon;
    float w = sqrt(max((direction.y - cells.horizon) / reach, 0.0));
    float along_sun = direction.x * cells.level.x + direction.z * cells.level.z;
    float aside = direction.x * cells.level.z - direction.z * cells.level.x;
    float across = atan(abs(aside), along_sun) / PI * cells.count.x;
    float rows = below ? cells.count.z : cells.count.y;
    return vec2(clamp(across, 0.0, cells.count.x - 0.001), (below ? cells.count.y : 0.0) + min(w * rows, rows - 0.001));
}

// Solid angle of a cell in that row, both sides of the sun together, sr. Cells share it evenly by the square of the place.
float sky_cell_solid_angle(SkyCells cells, float row) {
    bool below = row >= cells.count.y;
    float rows = below ? cells.count.z : cells.count.y;
    float k = row - (below ? cells.count.y : 0.0);
    float reach = abs((below ? -1.0 : 1.0) - cells.horizon);
    return reach * (2.0 * k + 1.0) / (rows * rows) * 2.0 * PI / cells.count.x;
}

// A direction uniform in a cell, from u in [0,1)^2, on either side of the sun: 1 or -1.
vec3 sky_cell_sample(SkyCells cells, vec2 cell, vec2 u, float side) {
    bool below = cell.y >= cells.count.y;
    float rows = below ? cells.count.z : cells.count.y;
    float k = cell.y - (below ? cells.count.y : 0.0);
    float reach = (below ? -1.0 : 1.0) - cells.horizon;
    float y = cells.horizon + reach * (k * k + u.y * (2.0 * k + 1.0)) / (rows * rows);
    float azimuth = PI * (cell.x + u.x) / cells.count.x;
    float level = sqrt(max(1.0 - y * y, 0.0));
    float toward = level * cos(azimuth);
    float aside = side * level * sin(azimuth);
    return vec3(toward * cells.level.x + aside * cells.level.z, y, toward * cells.level.z - aside * cells.level.x);
}
