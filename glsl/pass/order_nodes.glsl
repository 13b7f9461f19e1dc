// Single scattering by quadrature along the ray, for the field of order 1. The number of nodes is a uniform, so that the compiler does not write out
// the loops over nodes. That would take it seconds.
#include <absorber>
#include <view-column>
#include "sky/sums_add.glsl"

uniform int order_nodes;

const int GAUSS_NODES = 8;

int gauss_count() {
    return order_nodes;
}

#include "sky/gauss.glsl"

uniform GaussTable order_gauss;
