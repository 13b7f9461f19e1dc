#include "math/dialect.glsl"

// Copies of a solid in a row, a grid or a lattice about the origin. Along each axis there is a copy every `spacing`, and `count` copies in all.
// A spacing of 0 means no copies along that axis; a count of 0 means endless copies. The solid must stay within half a spacing of the origin.
//
// The nearest copy is the one in the cell of p, or a neighbour of it on the side of the cell where p is. A scene therefore computes the
// distance in 2 cells along each axis that repeats, which makes 2, 4 or 8 cells in all, and takes the least:
//
//     float d = INFINITY;
//     for (int i = 0; i < 4; i++) d = min(d, distance_box(repeat_cell(p, vec3(1.0, 0.0, 1.0), vec3(0.0), i), ...));
//
// The result is exact if all copies are alike. After Quilez, "Domain repetition".
float repeat_along(float x, float spacing, float count, bool neighbour) {
    // The place of copy 0, in spacings.
    float first = count > 0.0 ? -0.5 * (count - 1.0) : 0.0;
    float place = x / spacing - first;
    float cell = floor(place + 0.5);
    if (neighbour) cell += place < cell ? -1.0 : 1.0;
    if (count > 0.0) cell = clamp(cell, 0.0, count - 1.0);
    return cell + first;
}

// Returns the number of the copy along each axis. The copy at the origin has the number 0. If the count is even, the numbers are halves.
vec3 repeat_index(vec3 p, vec3 spacing, vec3 count, int i) {
    vec3 index = vec3(0.0);
    int choices = i;
    if (spacing.x > 0.0) {
        index.x = repeat_along(p.x, spacing.x, count.x, choices % 2 == 1);
        choices /= 2;
    }
    if (spacing.y > 0.0) {
        index.y = repeat_along(p.y, spacing.y, count.y, choices % 2 == 1);
        choices /= 2;
    }
    if (spacing.z > 0.0) index.z = repeat_along(p.z, spacing.z, count.z, choices % 2 == 1);
    return index;
}

// Returns p relative to the middle of copy i.
vec3 repeat_cell(vec3 p, vec3 spacing, vec3 count, int i) {
    return p - spacing * repeat_index(p, spacing, count, i);
}
