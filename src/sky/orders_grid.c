#include "sky/orders_grid.h"

#include "base/vec3.h"

#include <math.h>

static const double last_deg = 89.99;

double orders_grid_height(const OrdersGrid *grid, int row) {
    double y = row / (grid->rows - 1.0);
    return y * y * grid->top_m;
}

double orders_grid_sine(const OrdersGrid *grid, int column) {
    const OrdersColumns *across = &grid->across;
    double x = across->left + (across->right - across->left) * column / (grid->columns - 1);
    double chord = across->middle - sinh(x) / across->closeness;
    return fmin(1 - chord * chord / 2, sin(last_deg * degree));
}

/* Lagrange's polynomial through the nearest points. */
static OrdersPlace interpolate(double place, int count, int points) {
    double at = fmin(fmax(place, 0), count - 1);
    OrdersPlace result = {.first = (int)at - points / 2 + 1};
    if (result.first < 0) result.first = 0;
    if (result.first > count - points) result.first = count - points;
    for (int i = 0; i < points; i++) {
        double weight = 1;
        for (int k = 0; k < points; k++) {
            if (k != i) weight *= (at - result.first - k) / (i - k);
        }
        result.weights[i] = weight;
    }
    return result;
}

OrdersPlace orders_grid_row(const OrdersGrid *grid, double height) {
    double y = sqrt(fmax(0, height / grid->top_m));
    return interpolate(y * (grid->rows - 1), grid->rows, grid->points);
}

OrdersPlace orders_grid_column(const OrdersGrid *grid, double sine) {
    const OrdersColumns *across = &grid->across;
    double chord = sqrt(fmax(2 * (1 - sine), 0));
    double x =
        (asinh((across->middle - chord) * across->closeness) - across->left) / (across->right - across->left);
    return interpolate(x * (grid->columns - 1), grid->columns, grid->points);
}
