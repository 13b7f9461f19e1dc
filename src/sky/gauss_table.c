#include "sky/gauss_table.h"

#include "base/vec3.h"

#include <math.h>
#include <stdbool.h>

/* Legendre's polynomials of degrees 0 to n at x; p[n + 1] is one degree more. */
static void legendre(int n, double x, double *p) {
    p[0] = 1;
    p[1] = x;
    for (int k = 1; k <= n; k++) p[k + 1] = ((2 * k + 1) * x * p[k] - k * p[k - 1]) / (k + 1);
}

/* The i-th root of P_n on (-1,1), in ascending order, by Newton's method from Tricomi's start. `slope` is
 * P_n' at the root. */
static double find_root(int n, int i, double *slope) {
    double p[GAUSS_MOST_NODES + 2], x = -cos(pi * (i + 0.75) / (n + 0.5));
    for (int step = 0; step < 20; step++) {
        legendre(n, x, p);
        *slope = n * (p[n - 1] - x * p[n]) / (1 - x * x);
        x -= p[n] / *slope;
    }
    return x;
}

/* The same. What was found is kept, because tables ask for the same few roots again and again. */
static double legendre_root(int n, int i, double *slope) {
    static _Thread_local struct {
        bool known;
        double x, slope;
    } kept[GAUSS_MOST_NODES + 1][GAUSS_MOST_NODES];
    if (!kept[n][i].known) {
        kept[n][i].x = find_root(n, i, &kept[n][i].slope);
        kept[n][i].known = true;
    }
    *slope = kept[n][i].slope;
    return kept[n][i].x;
}

void gauss_nodes(int count, double *nodes, double *weights) {
    for (int i = 0; i < count; i++) {
        double slope, x = legendre_root(count, i, &slope);
        nodes[i] = (x + 1) / 2;
        /* This is half of the weight on (-1,1). */
        weights[i] = 1 / ((1 - x * x) * slope * slope);
    }
}

/* The polynomial through values f_j at the nodes is a sum of Legendre polynomials with the coefficients
 * (2k+1)/2 sum_j w_j P_k(x_j) f_j. This is exact because the quadrature is exact for products of degree 2n-2.
 * The integral of P_k from -1 to x is (P_{k+1}(x) - P_{k-1}(x)) / (2k+1). */
GaussTable gauss_table(int nodes) {
    GaussTable table = {{0}, {0}, {0}};
    double x[GAUSS_MOST], p[GAUSS_MOST][GAUSS_MOST + 2];
    gauss_nodes(nodes, table.node, table.weight);
    for (int i = 0; i < nodes; i++) {
        double slope;
        x[i] = legendre_root(nodes, i, &slope);
        legendre(nodes, x[i], p[i]);
    }
    for (int i = 0; i < nodes; i++) {
        for (int j = 0; j < nodes; j++) {
            /* The term of k = 0. */
            double sum = x[i] + 1;
            for (int k = 1; k < nodes; k++) sum += p[j][k] * (p[i][k + 1] - p[i][k - 1]);
            table.cumulative[nodes * i + j] = sum / 2 * table.weight[j];
        }
    }
    return table;
}
