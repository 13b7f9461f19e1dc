/* The light of the sky beyond the first order of scattering, and that of the ground, as tables
 * (glsl/sky/README.md). An air of one order with a black ground has none of them. */
#pragma once

#include "gl/resource.h"
#include "scene/glsl_slots.h"
#include "sky/frame.h"
#include "sky/orders_plan.h"

enum { ORDER_FIELDS = 4 };

/* For each order up to the fourth, the light of its field (by point and direction) and its moments; and the
 * moments of all together. They depend on the air, and neither on the sun nor on the observer. */
extern const ResourceKind order_light[ORDER_FIELDS], order_moments[ORDER_FIELDS], sky_moments;

/* The further light by direction, for a sun and an observer; and the ground's alone, for an air of one order.
 */
extern const ResourceKind sky_further, sky_ground;

/* Whether there is more than one order, or a ground that is not black. */
bool further_is_there(const Atmosphere *atmosphere);

/* The plan of a frame's quality. */
const OrdersPlan *further_plan(const Frame *frame);

/* Fills <further> and <view-column>. */
void further_slots(SlotList *slots, const Atmosphere *atmosphere);

/* Adds the uniforms of the file that is in the slot <view-column>. */
void further_uniforms(const Frame *frame, Uniforms *uniforms);

/* Appends the quality, if the air has further orders. */
void further_key(const Frame *frame, Text *key);
