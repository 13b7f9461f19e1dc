/* Gauss-Legendre quadrature on (0,1), and the matrix that integrates up to each node. */
#pragma once

enum { GAUSS_MOST = 12 };

/* The GLSL struct of the same name in sky/gauss.glsl has the same members. */
typedef struct GaussTable {
    double node[GAUSS_MOST], weight[GAUSS_MOST];
    /* The weight of node j in the integral up to node i is cumulative[nodes * i + j]. */
    double cumulative[GAUSS_MOST * GAUSS_MOST];
} GaussTable;

enum { GAUSS_MOST_NODES = 48 };

/* The nodes on (0,1) and their weights, for 1 to GAUSS_MOST_NODES nodes, accurate to 1e-14. */
void gauss_nodes(int count, double *nodes, double *weights);

/* The table for 1 to GAUSS_MOST nodes, accurate to 1e-14. */
GaussTable gauss_table(int nodes);
