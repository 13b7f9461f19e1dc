#include "render/sun_disk.h"

#include "render/sky_reference.h"

#include <math.h>

void sun_disk_radiance(const Atmosphere *atmosphere, const double sun[3], const double direction[3],
                       double radiance[3]) {
    const double pi = acos(-1.0), radius = SUN_RADIUS_DEG * pi / 180;
    double squared = 0, transmittance[3];
    for (int i = 0; i < 3; i++) squared += (sun[i] - direction[i]) * (sun[i] - direction[i]);
    bool inside =
        squared < 4 * sin(radius / 2) * sin(radius / 2); /* the chord keeps its digits, a cosine does not */
    if (inside)
        sky_reference_transmittance(atmosphere, atmosphere->observer_height_m, direction, transmittance);
    for (int c = 0; c < 3; c++) {
        radiance[c] =
            inside ? atmosphere->sun_irradiance[c] * transmittance[c] / (pi * sin(radius) * sin(radius)) : 0;
    }
}
