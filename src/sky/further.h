/* The light of the sky beyond the first order of scattering, and that of the ground, by direction: a small
 * table for each position of the sun (glsl/sky/README.md). An air of one order with a black ground has none.
 */
#pragma once

#include "scene/glsl_slots.h"
#include "sky/orders.h"

/* The observer's rays; the further light; and the ground's light alone, for an air of one order. */
extern const ResourceKind further_rays, sky_further, sky_ground;

/* All tables of the further light, in the order in which they are filled. */
#define FURTHER_TABLES                                                                                       \
    &order_rays[0], &order_light[0], &order_moments[0], &order_rays[1], &order_light[1], &order_moments[1],  \
        &order_rays[2], &order_light[2], &order_moments[2], &order_rays[3], &order_light[3],                 \
        &order_moments[3], &sky_moments, &further_rays, &sky_further, &sky_ground

/* Whether there is more than one order, or a ground that is not black. */
bool further_is_there(const Atmosphere *atmosphere);

/* Fills <further> and <view-column>. */
void further_slots(SlotList *slots, const Atmosphere *atmosphere);

/* Adds the uniforms of the file that is in the slot <view-column>. */
void further_uniforms(const Frame *frame, Uniforms *uniforms);
