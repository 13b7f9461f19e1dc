/* The sky's ground truth in colours: sky_reference() of each band of atmosphere.spectrum, brought to linear
 * sRGB. With the spectrum rgb it is sky_reference() itself. */
#pragma once

#include "scene/atmosphere.h"

/* The arguments are those of sky_reference(). With a spectrum a component may be below 0: such a colour is
 * outside of what linear sRGB can show. */
void sky_truth(const Atmosphere *atmosphere, double height_m, const double view[3], const double sun[3],
               double radiance[3]);
