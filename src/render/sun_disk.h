/* The sun's disk: as wide as it is seen from the Earth, uniform, reddened by the air in front of each of its
 * points. */
#pragma once

#include "scene/atmosphere.h"

#define SUN_RADIUS_DEG 0.2666

/* Radiance of the disk's point in `direction` as seen from the observer: sun irradiance times transmittance
 * over pi sin^2 of the radius, 0 outside of the disk and where the planet is in the way. `sun` points to the
 * disk's middle; unit vectors. */
void sun_disk_radiance(const Atmosphere *atmosphere, const double sun[3], const double direction[3],
                       double radiance[3]);
