/* The unblocked sky's irradiance by a surface's normal, tabulated: the control variate of --light control. */
#pragma once

#include "sky/sky_patches.h"

extern const ResourceKind sky_irradiance;
