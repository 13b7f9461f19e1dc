#include "sky/scene_air.h"

#include "scene/spectrum.h"

#include <math.h>

/* Adds a band's share of the four coefficients of a channel. */
static void add_band(SceneAir *sum, const Atmosphere *air, const double weights[3], int c) {
    for (int k = 0; k < 3; k++) {
        double mie = weights[k] * air->mie * air->mie_scatter_per_m[k];
        sum->rayleigh_scatter[c] += weights[k] * air->rayleigh * air->rayleigh_scatter_per_m[k];
        sum->mie_scatter[c] += mie;
        sum->mie_extinction[c] += mie * air->mie_extinction_ratio;
        sum->ozone_absorb[c] += weights[k] * air->ozone * air->ozone_absorb_per_m[k];
    }
}

SceneAir scene_air(const Atmosphere *atmosphere) {
    SceneAir sum = {0};
    for (int c = 0; c < 3; c++) {
        double white = 0;
        for (int band = 0; band < spectrum_bands(atmosphere); band++) {
            Atmosphere air = spectrum_band(atmosphere, band);
            double matrix[3][3];
            spectrum_matrix(atmosphere, band, matrix);
            add_band(&sum, &air, matrix[c], c);
            for (int k = 0; k < 3; k++) white += matrix[c][k];
        }
        double *const coefficients[] = {&sum.rayleigh_scatter[c], &sum.mie_scatter[c], &sum.mie_extinction[c],
                                        &sum.ozone_absorb[c]};
        /* A channel's weights may be below 0, so that a mean may be so too. No air adds light by that. */
        for (int i = 0; i < 4; i++) *coefficients[i] = fmax(*coefficients[i] / white, 0);
    }
    return sum;
}

void scene_air_uniforms(const Atmosphere *atmosphere, Uniforms *uniforms) {
    SceneAir air = scene_air(atmosphere);
    uniforms_declared_in(uniforms, "pass/air.glsl");
    uniforms_vec3(uniforms, "air_rayleigh_scatter_per_m", air.rayleigh_scatter);
    uniforms_vec3(uniforms, "air_mie_scatter_per_m", air.mie_scatter);
    uniforms_vec3(uniforms, "air_mie_extinction_per_m", air.mie_extinction);
    uniforms_vec3(uniforms, "air_ozone_absorb_per_m", air.ozone_absorb);
}
