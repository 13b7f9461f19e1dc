/* The grid on which the CPU's fields of light are held (sky/sky_orders.h): altitudes, which are its rows and
 * even in the square root, and local elevations of the sun, which are its columns (orders_columns()). */
#pragma once

#include "sky/orders_plan.h"

typedef struct OrdersGrid {
    int rows, columns;
    /* How many points along each axis an interpolation takes: 2 (linear) or 4 (cubic). */
    int points;
    double top_m;
    OrdersColumns across;
} OrdersGrid;

/* Neighbours along an axis, from `first` on, and their weights. */
typedef struct OrdersPlace {
    int first;
    double weights[4];
} OrdersPlace;

double orders_grid_height(const OrdersGrid *grid, int row);

/* The sine of the sun's elevation. The last column stands a hundredth of a degree off the zenith, where
 * azimuths about the sun have a meaning. */
double orders_grid_sine(const OrdersGrid *grid, int column);

/* Beyond the grid's ends the values at the ends are taken. */
OrdersPlace orders_grid_row(const OrdersGrid *grid, double height);
OrdersPlace orders_grid_column(const OrdersGrid *grid, double sine);
