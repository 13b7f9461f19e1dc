// Of the light that aerosols scatter on its way to the eye, a share goes on so nearly straight that it counts as not scattered. The weights of the
// further orders leave out the same share (order_aerosol_weight in pass/orders.glsl), so that no light is lost or counted twice.
#include "math/dialect.glsl"

// The share of the aerosols' extinction that is left.
uniform float view_aerosol_kept;

vec2 view_column(vec2 column) {
    return vec2(column.x, column.y * view_aerosol_kept);
}
