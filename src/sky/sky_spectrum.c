#include "sky/sky_spectrum.h"

#include "scene/spectrum.h"
#include "sky/further.h"

#include <stdio.h>

/* The further light is a colour. An air without a spectrum that has it counts as one band. */
static bool has_bands(const Atmosphere *atmosphere) {
    return atmosphere->spectrum != SPECTRUM_RGB || further_is_there(atmosphere);
}

void sky_spectrum_slots(SlotList *slots, const Atmosphere *atmosphere) {
    bool bands = has_bands(atmosphere);
    char count[40];
    snprintf(count, sizeof count, "const int BANDS = %d;", spectrum_bands(atmosphere));
    slot_file(slots, "spectrum", bands ? "pass/spectrum_bands.glsl" : "pass/spectrum_rgb.glsl");
    slot_text(slots, "bands", count);
    slot_file(slots, "sums-add", bands ? "pass/sums_add_bands.glsl" : "sky/sums_add.glsl");
    slot_file(slots, "light-sums", bands ? "pass/light_sums_bands.glsl" : "pass/light_sums_rgb.glsl");
    slot_file(slots, "shade", bands ? "pass/shade_bands.glsl" : "pass/shade_rgb.glsl");
    slot_file(slots, "root", bands ? "sky/root_signed.glsl" : "sky/root_plain.glsl");
}

static void add_vec3(Uniforms *uniforms, const char *name, int band, const double value[3], double factor) {
    double scaled[3];
    char element[80];
    for (int c = 0; c < 3; c++) scaled[c] = factor * value[c];
    snprintf(element, sizeof element, "%s[%d]", name, band);
    uniforms_vec3(uniforms, element, scaled);
}

static void band_uniforms(const Atmosphere *atmosphere, int band, Uniforms *uniforms) {
    Atmosphere air = spectrum_band(atmosphere, band);
    double matrix[3][3];
    spectrum_matrix(atmosphere, band, matrix);
    for (int c = 0; atmosphere->spectrum == SPECTRUM_RGB && c < 3; c++) matrix[c][c] = air.sun_irradiance[c];
    add_vec3(uniforms, "band_rayleigh_scatter_per_m", band, air.rayleigh_scatter_per_m, air.rayleigh);
    add_vec3(uniforms, "band_mie_scatter_per_m", band, air.mie_scatter_per_m, air.mie);
    add_vec3(uniforms, "band_mie_extinction_per_m", band, air.mie_scatter_per_m,
             air.mie * air.mie_extinction_ratio);
    add_vec3(uniforms, "band_ozone_absorb_per_m", band, air.ozone_absorb_per_m, air.ozone);
    add_vec3(uniforms, "band_ground_albedo", band, air.ground_albedo, 1);
    add_vec3(uniforms, "band_to_red", band, matrix[0], 1);
    add_vec3(uniforms, "band_to_green", band, matrix[1], 1);
    add_vec3(uniforms, "band_to_blue", band, matrix[2], 1);
}

void sky_spectrum_uniforms(const Atmosphere *atmosphere, Uniforms *uniforms) {
    if (!has_bands(atmosphere)) {
        uniforms_declared_in(uniforms, "pass/spectrum_rgb.glsl");
        uniforms_vec3(uniforms, "ground_albedo", atmosphere->ground_albedo);
        return;
    }
    uniforms_declared_in(uniforms, "pass/spectrum_bands.glsl");
    for (int band = 0; band < spectrum_bands(atmosphere); band++) band_uniforms(atmosphere, band, uniforms);
}
