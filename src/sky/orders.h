/* The orders of scattering as tables: the fields of light that was scattered once, twice and so on, as
 * moments about the sun's direction (glsl/sky/README.md, glsl/sky/orders.glsl). They depend on the air, the
 * ground and the quality, and neither on the sun nor on the observer. So they are filled once for an air. All
 * lengths are in metres, and all light is that of a sun of irradiance 1 in each channel. */
#pragma once

#include "gl/resource.h"
#include "sky/frame.h"
#include "sky/orders_plan.h"

/* For each order up to the fifth:
 *
 *   order_rays     the nodes of the rays along which its field is gathered (glsl/pass/rays.glsl)
 *   order_light    its radiance: a row for each point of the grid, a column for each direction
 *   order_moments  its moments, as tiles (glsl/sky/orders.glsl), a texel for each point of the grid
 *
 * Each fills from the one before it, and the light of an order from the moments of the order before. They are
 * inputs of sky_moments, and are wanted only as such. */
extern const ResourceKind order_rays[ORDER_FIELDS], order_light[ORDER_FIELDS], order_moments[ORDER_FIELDS];

/* The moments of all orders together, laid out as those of order 1. */
extern const ResourceKind sky_moments;

/* The plan of a frame's quality; of the default one if the frame names none. Never NULL. */
const OrdersPlan *orders_plan_of(const Frame *frame);

/* Appends the quality to the key of a table that depends on it. An air of one order appends nothing. */
void orders_key(const Frame *frame, Text *key);

/* Add the uniforms of passes that gather light along rays (pass/orders.glsl), and of those that compute these
 * rays (pass/rays.glsl). `nodes` is the number of nodes of a ray that does not pass its perigee, GAUSS_MOST
 * at most. */
void orders_gather_uniforms(const Frame *frame, int nodes, Uniforms *uniforms);
void orders_ray_uniforms(int nodes, Uniforms *uniforms);
