#include "math/dialect.glsl"

// Copies of a solid in a row, a grid or a lattice about the origin: a copy every `spacing` along each axis (0: none along this
// one), `count` copies (0: without end). The solid stays within half a spacing of the origin. The nearest copy may be a
// neighbour of the one in whose cell p is, but only toward p's side of the cell; so a scene asks 2 cells along each axis
// that repeats, 2, 4 or 8 in all, and takes the least:
//
//     float d = INFINITY;
//     for (int i = 0; i < 4; i++) d = min(d, distance_box(repeat_cell(p, vec3(1.0, 0.0, 1.0), vec3(0.0), i), ...));
//
// That is exact while all copies are alike. After Quilez, "Domain repetition".
float repeat_along(float x, float spacing, float count, bool neighbour) {
    float first = count > 0.0 ? -0.5 * (count - 1.0) : 0.0; // where copy 0 is, in spacings
    float place = x / spacing - first;
    float cell = floor(place + 0.5);
    if (neighbour) cell += place < cell ? -1.0 : 1.0;
    if (count > 0.0) cell = clamp(cell, 0.0, count - 1.0);
    return cell + first;
}

// The number of the copy along each axis, 0 for the one at the origin (halves where there are even numbers of copies).
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

// p from the middle of that copy.
vec3 repeat_cell(vec3 p, vec3 spacing, vec3 count, int i) {
    return p - spacing * repeat_index(p, spacing, count, i);
}
