/* The sky's ground truth: adaptive quadrature in double precision on the CPU, against which the shaders are
 * tested.
 *
 * In world coordinates y is up at the observer, who is height_m (0 to 1e6) above the planet, within the
 * atmosphere or outside of it. Directions need not be normalised but must not be 0. Nothing here fails or
 * allocates: for all settings that atmosphere_set and atmosphere_check accept the values are finite and never
 * below 0. */
#pragma once

#include "scene/atmosphere.h"

/* The radiance of the single-scattering sky toward `view`, up to the ground or the top of the atmosphere, for
 * a point sun toward `sun`. Points that the planet hides from the sun get no light. The relative error is at
 * most 1e-8 wherever the value is above 1e-12. A call takes about a millisecond. */
void sky_reference(const Atmosphere *atmosphere, double height_m, const double view[3], const double sun[3],
                   double radiance[3]);

/* The radiance toward `view` of sunlight that the ground has scattered: 0 where the ray does not end there.
 * The relative error is that of the columns, 1e-12. */
void sky_reference_ground(const Atmosphere *atmosphere, double height_m, const double view[3],
                          const double sun[3], double radiance[3]);

/* The share of the light from beyond the atmosphere that reaches the observer from `direction`; 0 where the
 * planet blocks it. */
void sky_reference_transmittance(const Atmosphere *atmosphere, double height_m, const double direction[3],
                                 double transmittance[3]);
