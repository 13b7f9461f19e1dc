/* Gauss-Legendre quadrature on (0,1), with the matrix that integrates up to each node. */
#pragma once

enum { GAUSS_MOST = 12 };

/* As the GLSL struct of the same name (sky/gauss.glsl). */
typedef struct GaussTable {
    double node[GAUSS_MOST], weight[GAUSS_MOST];
    double cumulative[GAUSS_MOST * GAUSS_MOST]; /* [12 i + j] */
} GaussTable;

/* `nodes` from 1 to GAUSS_MOST. Good to 1e-14. */
GaussTable gauss_table(int nodes);
