#include "sky/sky_truth.h"

#include "scene/spectrum.h"
#include "sky/sky_reference.h"

void sky_truth(const Atmosphere *atmosphere, double height_m, const double view[3], const double sun[3],
               double radiance[3]) {
    for (int c = 0; c < 3; c++) radiance[c] = 0;
    for (int band = 0; band < spectrum_bands(atmosphere); band++) {
        Atmosphere air = spectrum_band(atmosphere, band);
        double channels[3];
        sky_reference(&air, height_m, view, sun, channels);
        spectrum_add(atmosphere, band, channels, radiance);
    }
}
