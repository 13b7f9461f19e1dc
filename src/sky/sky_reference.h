/* The sky's ground truth: adaptive quadrature in double on the CPU, to judge the shaders by.
 *
 * World: y up at the observer, who stands height_m (0 to 1e6) above the planet, within the atmosphere or
 * outside of it. Directions need not be normalised, but must not be 0. Nothing here fails or allocates: all
 * settings that atmosphere_set and atmosphere_check accept give finite values, never below 0. */
#pragma once

#include "scene/atmosphere.h"

/* Radiance of the single-scattering sky toward `view`, up to the ground or the top of the atmosphere, for a
 * sun without size toward `sun`; points that the planet hides from the sun get no light. Good to 1e-8 of the
 * value wherever that is above 1e-12; about a millisecond. */
void sky_reference(const Atmosphere *atmosphere, double height_m, const double view[3], const double sun[3],
                   double radiance[3]);

/* Share of the light from beyond the atmosphere that reaches the observer from `direction`; 0 where the
 * planet is in the way. */
void sky_reference_transmittance(const Atmosphere *atmosphere, double height_m, const double direction[3],
                                 double transmittance[3]);
