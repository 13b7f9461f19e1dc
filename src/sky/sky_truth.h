/* The sky's ground truth in colours, with all orders of scattering and the ground that the atmosphere has:
 * single scattering (sky/sky_reference.h) and the further orders (sky/sky_orders.h) of each band of
 * atmosphere.spectrum, brought to linear sRGB. */
#pragma once

#include "sky/sky_orders.h"

typedef struct SkyTruth SkyTruth;

/* Solves for the further orders, if there are any: about 20 seconds a band. The observer's height has no
 * influence. `watch` may be NULL. Returns NULL if it was stopped. */
SkyTruth *sky_truth_create(const Atmosphere *atmosphere, const SkyWatch *watch);
void sky_truth_destroy(SkyTruth *truth);

/* The arguments are those of sky_reference(). With a spectrum a component may be below 0: such a colour is
 * outside of what linear sRGB can show. Without further orders the error is that of sky_reference(). */
void sky_truth_ask(const SkyTruth *truth, double height_m, const double view[3], const double sun[3],
                   double radiance[3]);
