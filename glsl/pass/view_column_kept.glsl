// Of the light that aerosols scatter on its way to the eye, a share goes on so nearly straight that it counts as not scattered. What it would have
// lost elsewhere is left out of the further orders (pass/orders.glsl).
#include "math/dialect.glsl"

// The share of the aerosols' extinction that is left.
uniform float view_aerosol_kept;

vec2 view_column(vec2 column) {
    return vec2(column.x, column.y * view_aerosol_kept);
}
