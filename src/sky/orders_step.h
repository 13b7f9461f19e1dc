/* One step of the CPU's solver of the further orders (sky/sky_orders.h): the field of an order from that of
 * the order before. */
#pragma once

#include "sky/orders_field.h"
#include "sky/sky_orders_plan.h"

typedef struct OrdersStep {
    const OrdersAir *air;
    const OrdersGrid *grid;
    const OrdersGauss *gauss;
    const SkyOrderPlan *plan;
    /* The field of the order before, packed. NULL for order 1. */
    const OrdersField *before;
    const SkyWatch *watch;
    /* The shares of the whole that are done before this step and after it. */
    double from, to;
} OrdersStep;

/* Returns false if the watch stopped it. The field has to be freed in any case. */
bool orders_step(const OrdersStep *step, OrdersField *field);
