/* The orders of scattering beyond the first, in double precision on the CPU: the ground truth of the shaders'
 * further light (glsl/sky/README.md). It shares none of their code, and has columns in closed form
 * (sky/air_column.h), quadratures and interpolations of its own.
 *
 * Light that was scattered k times, by the air or by the ground, has the order k. At a point its radiance
 * depends on the direction, the altitude and the local elevation of the sun, but neither on the observer nor
 * on the place. So the field of each order is computed once, on a grid (sky/orders_field.h), from the field
 * of the order before. The light that is seen is gathered along the view's ray from the sum of all fields. */
#pragma once

#include "scene/atmosphere.h"
#include "sky/sky_orders_plan.h"

/* The plan of the ground truth. */
extern const SkyOrdersPlan sky_orders_plan;

typedef struct SkyOrders SkyOrders;

/* Solves for an air and a ground with as many orders as the atmosphere says. It takes about 20 seconds by
 * sky_orders_plan, and no time if only one order counts. The observer's height and the sun's irradiance have
 * no influence. `watch` may be NULL. Returns NULL if it was stopped. */
SkyOrders *sky_orders_create(const Atmosphere *atmosphere, const SkyOrdersPlan *plan, const SkyWatch *watch);
void sky_orders_destroy(SkyOrders *orders);

/* The radiance of all light of the orders from the second on, for a sun of irradiance 1. The arguments are
 * those of sky_reference(). */
void sky_orders_radiance(const SkyOrders *orders, double height_m, const double view[3], const double sun[3],
                         double radiance[3]);

/* The radiance of order 1, for a sun of irradiance 1: sunlight scattered by the air, and by the ground. It is
 * as accurate as the quadrature of the plan's last nodes. */
void sky_orders_first(const SkyOrders *orders, double height_m, const double view[3], const double sun[3],
                      double radiance[3]);
