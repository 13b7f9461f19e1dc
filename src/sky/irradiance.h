/* A table of the unblocked sky's irradiance for each normal of a surface: the control variate of --light
 * control. */
#pragma once

#include "sky/sky_patches.h"

extern const ResourceKind sky_irradiance;
