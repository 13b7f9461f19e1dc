// The quadrature along rays of the passes that compute the further orders. Its number of nodes is a uniform, so that the loops over nodes are not written out
// by the compiler, which takes it long.
uniform int order_nodes;

const int GAUSS_NODES = 12;

int gauss_count() {
    return order_nodes;
}

#include "sky/gauss.glsl"

uniform GaussTable order_gauss;
