/* The orders of scattering as tables: the fields of light that was scattered once, twice and so on, as
 * moments about the sun's direction (glsl/sky/README.md). They depend on the air, and neither on the sun nor
 * on the observer. */
#pragma once

#include "gl/resource.h"
#include "sky/frame.h"
#include "sky/orders_plan.h"

/* For each order up to the fourth: the rays along which its field is gathered, its light by point and
 * direction, and its moments. */
extern const ResourceKind order_rays[ORDER_FIELDS], order_light[ORDER_FIELDS], order_moments[ORDER_FIELDS];

/* The moments of all orders together. */
extern const ResourceKind sky_moments;

/* The plan of a frame's quality. */
const OrdersPlan *orders_plan_of(const Frame *frame);

/* Appends the quality, if the air has further orders. */
void orders_key(const Frame *frame, Text *key);

/* Adds the uniforms of passes that gather light along rays of `nodes` nodes (pass/orders.glsl), or that
 * compute these rays (pass/rays.glsl). */
void orders_gather_uniforms(const Frame *frame, int nodes, Uniforms *uniforms);
void orders_ray_uniforms(int nodes, Uniforms *uniforms);
