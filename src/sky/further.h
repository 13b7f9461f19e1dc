/* The further light: all light of the sky but what the air scatters once. It consists of the further orders
 * of scattering and of the light that the ground reflects (glsl/sky/README.md). A small table holds it by
 * direction, for one air, one observer and one position of the sun. */
#pragma once

#include "sky/orders.h"
#include "source/glsl_slots.h"

/* The nodes of the observer's rays; the further light; and the ground's light alone, which takes its place if
 * the air has one order. The last two have the same sampler, and no frame wants both. */
extern const ResourceKind further_rays, sky_further, sky_ground;

/* All tables of the further light, each behind its inputs: a part of a list of kinds (gl/resource.h). */
#define FURTHER_TABLES                                                                                       \
    &order_rays[0], &order_light[0], &order_moments[0], &order_rays[1], &order_light[1], &order_moments[1],  \
        &order_rays[2], &order_light[2], &order_moments[2], &order_rays[3], &order_light[3],                 \
        &order_moments[3], &order_rays[4], &order_light[4], &order_moments[4], &sky_moments, &further_rays,  \
        &sky_further, &sky_ground

/* Whether there is further light: the air has more than one order, or the ground is not black. */
bool further_is_there(const Atmosphere *atmosphere);

/* Fills the slots <further> and <view-column>. */
void further_slots(SlotList *slots, const Atmosphere *atmosphere);

/* Adds the uniforms of the file that is in the slot <view-column>. */
void further_uniforms(const Frame *frame, Uniforms *uniforms);
