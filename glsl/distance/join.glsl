#include "math/dialect.glsl"

// Edges between two solids, as in Mercury's library hg_sdf. The names of a and b are those of distance/boolean.glsl, and `radius` is how far from the
// other surface an edge begins.
//
// Stairs, grooves and tongues change by at most one metre a metre. The others do so where the surfaces of a and b meet at right angles. Elsewhere they
// may change by JOIN_STEEPNESS metres a metre, so divide by it what march() is given.
const float JOIN_STEEPNESS = 1.41421357;

float op_chamfer_union(float a, float b, float radius) {
    return min(min(a, b), (a + b - radius) * sqrt(0.5));
}

float op_chamfer_intersection(float a, float b, float radius) {
    return -op_chamfer_union(-a, -b, radius);
}

float op_chamfer_subtraction(float a, float b, float radius) {
    return -op_chamfer_union(-a, b, radius);
}

// A stair from one surface to the other, of count - 1 steps, each radius / count high and deep.
float op_stairs_union(float a, float b, float radius, float count) {
    float rise = radius / count;
    float ramp = abs(mod(b - radius - a + rise, 2.0 * rise) - rise);
    return min(min(a, b), 0.5 * (a + b - radius + ramp));
}

float op_stairs_intersection(float a, float b, float radius, float count) {
    return -op_stairs_union(-a, -b, radius, count);
}

float op_stairs_subtraction(float a, float b, float radius, float count) {
    return -op_stairs_union(-a, b, radius, count);
}

// A chamfer with `count` half columns side by side on it.
float op_columns_union(float a, float b, float radius, float count) {
    float column = radius * sqrt(0.5) / count;
    float over = (a + b - radius) * sqrt(0.5);
    float aside = (b - a) * sqrt(0.5);
    // The middle of the nearest column. The columns' middles are two of their radii apart, and the middle of all is 0.
    float place = clamp(floor(0.5 * (aside / column + count)), 0.0, count - 1.0);
    float to_column = length(vec2(over, aside - (2.0 * place + 1.0 - count) * column)) - column;
    return min(min(a, b), min(over, to_column));
}

float op_columns_intersection(float a, float b, float radius, float count) {
    return -op_columns_union(-a, -b, radius, count);
}

float op_columns_subtraction(float a, float b, float radius, float count) {
    return -op_columns_union(-a, b, radius, count);
}

// A tube where the two surfaces meet, and nothing else.
float op_pipe(float a, float b, float radius) {
    return length(vec2(a, b)) - radius;
}

// The solid a with a notch along the surface of b, as deep as it is wide to each side.
float op_engrave(float a, float b, float radius) {
    return max(a, (a + radius - abs(b)) * sqrt(0.5));
}

// The solid a with a groove along the surface of b, half_width to each side.
float op_groove(float a, float b, float depth, float half_width) {
    return max(a, min(a + depth, half_width - abs(b)));
}

// The solid a with a tongue along the surface of b, half_width to each side.
float op_tongue(float a, float b, float height, float half_width) {
    return min(a, max(a - height, abs(b) - half_width));
}
