#include "scene/atmosphere.h"

#include "base/known.h"
#include "base/number.h"
#include "base/text.h"
#include "base/vec3.h"
#include "scene/value.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* What the presets share: the paper's numbers with its misprints mended. */
#define SIMMONS2017                                                                                          \
    .planet_radius_m = 6360e3, .top_radius_m = 6420e3, .rayleigh_scale_height_m = 7994,                      \
    .mie_scale_height_m = 1200, .mie_scatter_per_m = {21e-6, 21e-6, 21e-6}, .mie_extinction_ratio = 1.1,     \
    .mie_g = 0.76, .rayleigh = 1, .mie = 1, .ozone_absorb_per_m = {0.650e-6, 1.881e-6, 0.085e-6},            \
    .ozone_height_m = 25e3, .ozone_half_width_m = 15e3, .sun_irradiance = {20, 20, 20},                      \
    .wavelengths_nm = {680, 550, 440}, .refractive_index = 1.0003, .molecules_per_m3 = 2.545e25,             \
    .observer_height_m = 1

static const AtmospherePreset presets[] = {
    {"simmons2017",
     "Simmons 2017, misprints mended; the default",
     {SIMMONS2017, .rayleigh_scatter_per_m = {5.8e-6, 13.5e-6, 33.1e-6}, .orders = 1}},
    {"simmons2017-author",
     "the coefficients of the author's program (red scatters 3.8e-6 per metre), without its two bugs",
     {SIMMONS2017, .rayleigh_scatter_per_m = {3.8e-6, 13.5e-6, 33.1e-6}, .orders = 1}},
    {"simmons2017-ozone",
     "simmons2017 with ozone, a tent of 25 km +- 15 km (Bruneton 2017)",
     {SIMMONS2017, .rayleigh_scatter_per_m = {5.8e-6, 13.5e-6, 33.1e-6}, .ozone = 1, .orders = 1}},
    {"earth",
     "simmons2017-ozone with all orders of scattering, a ground of albedo 0.1, and colours from 6 "
     "wavelengths",
     {SIMMONS2017, .rayleigh_scatter_per_m = {5.8e-6, 13.5e-6, 33.1e-6}, .ozone = 1, .orders = INFINITY,
      .ground_albedo = {0.1, 0.1, 0.1}, .spectrum = 6}},
};

#define ROW(member, length, least, most, text)                                                               \
    .name = #member, .setting = "atmosphere." #member, .offset = offsetof(Atmosphere, member),               \
    .count = length, .min = least, .max = most, .description = text
#define FIELD(...)                                                                                           \
    { ROW(__VA_ARGS__) }

static const AtmosphereField fields[] = {
    FIELD(planet_radius_m, 1, 1e3, 1e9, "radius of the planet, m"),
    FIELD(top_radius_m, 1, 1e3, 1e9, "radius of the top of the atmosphere, m; no density above"),
    FIELD(observer_height_m, 1, 0, 1e6, "height of every ray that escapes a scene, m"),
    FIELD(rayleigh, 1, 0, 1e6, "multiplies the density of air; 0 leaves it out"),
    FIELD(mie, 1, 0, 1e6, "multiplies the density of aerosols; 0 leaves them out"),
    FIELD(rayleigh_scale_height_m, 1, 1, 1e6, "height over which the air thins by e, m"),
    FIELD(mie_scale_height_m, 1, 1, 1e6, "height over which the aerosols thin by e, m"),
    FIELD(rayleigh_scatter_per_m, 3, 0, 1, "Rayleigh scattering at height 0, 1/m"),
    FIELD(mie_scatter_per_m, 3, 0, 1, "Mie scattering at height 0, 1/m"),
    FIELD(mie_extinction_ratio, 1, 1, 1e3, "Mie extinction over Mie scattering"),
    FIELD(mie_g, 1, -0.999, 0.999, "Cornette-Shanks asymmetry of the Mie phase function"),
    FIELD(ozone, 1, 0, 1e6, "multiplies the density of ozone; 1 is 300 Dobson units, 0 leaves it out"),
    FIELD(ozone_absorb_per_m, 3, 0, 1,
          "absorption at the middle of the ozone layer, 1/m; a spectrum has ozone's own"),
    FIELD(ozone_height_m, 1, 0, 1e6, "height of the middle of the ozone layer, m"),
    FIELD(ozone_half_width_m, 1, 1, 1e6, "from the middle to no ozone, m; density falls linearly"),
    {ROW(orders, 1, 1, 1000, "how many times light is scattered at most, by air or ground"), .whole = true,
     .words = {{"all", INFINITY}}},
    FIELD(ground_albedo, 3, 0, 1, "albedo of the planet, which is matte; 0 is black"),
    {ROW(spectrum, 1, 1, 0, "wavelengths that colours are computed from; rgb: the settings' three channels"),
     .words = {{"rgb", SPECTRUM_RGB}, {"3", 3}, {"6", 6}}},
    FIELD(mie_angstrom, 1, -4, 8, "with a spectrum, Mie scattering goes as wavelength to minus this"),
    FIELD(sun_irradiance, 3, 0, 1e6, "the sun's irradiance above the atmosphere"),
    FIELD(wavelengths_nm, 3, 100, 1e5, "wavelengths of R, G, B, nm; Rayleigh by the formula"),
    FIELD(refractive_index, 1, 1, 2, "of air at height 0; Rayleigh by the formula"),
    FIELD(molecules_per_m3, 1, 1, 1e40, "of air at height 0, 1/m3; Rayleigh by the formula"),
};

const AtmospherePreset *atmosphere_preset(int index) {
    return index >= 0 && index < (int)(sizeof presets / sizeof *presets) ? &presets[index] : NULL;
}

const AtmosphereField *atmosphere_field(int index) {
    return index >= 0 && index < (int)(sizeof fields / sizeof *fields) ? &fields[index] : NULL;
}

const double *atmosphere_value(const Atmosphere *atmosphere, const AtmosphereField *field) {
    return (const double *)(const void *)((const char *)atmosphere + field->offset);
}

bool atmosphere_same(const Atmosphere *a, const Atmosphere *b, const AtmosphereField *field) {
    return memcmp(atmosphere_value(a, field), atmosphere_value(b, field),
                  (size_t)field->count * sizeof(double)) == 0;
}

void atmosphere_print_value(const Atmosphere *atmosphere, const AtmosphereField *field, Text *out) {
    const double *value = atmosphere_value(atmosphere, field);
    for (int i = 0; i < ATMOSPHERE_WORDS && field->words[i].word; i++) {
        if (*value == field->words[i].value) {
            text_print(out, "%s", field->words[i].word);
            return;
        }
    }
    for (int i = 0; i < field->count; i++) text_print(out, "%s%.9g", i ? "," : "", value[i]);
}

void atmosphere_print_range(const AtmosphereField *field, Text *out) {
    bool numbers = field->min <= field->max;
    if (numbers) text_print(out, "%g to %g", field->min, field->max);
    for (int i = 0; i < ATMOSPHERE_WORDS && field->words[i].word; i++) {
        bool last = i + 1 == ATMOSPHERE_WORDS || !field->words[i + 1].word;
        text_print(out, "%s%s", !numbers && !i ? "" : last ? " or " : ", ", field->words[i].word);
    }
}

bool atmosphere_choose(Atmosphere *atmosphere, const char *preset, Error *error) {
    Known known = known_to(preset, strlen(preset));
    for (int i = 0; atmosphere_preset(i); i++) {
        if (strcmp(presets[i].name, preset) == 0) {
            *atmosphere = presets[i].atmosphere;
            known_free(&known);
            return true;
        }
        known_add(&known, presets[i].name);
    }
    return known_fail(&known, STATUS_USAGE, error, "unknown atmosphere '%s'", preset);
}

double atmosphere_rayleigh_formula(double refractive_index, double molecules_per_m3, double wavelength_m) {
    double contrast = refractive_index * refractive_index - 1;
    return 8 * pi * pi * pi * contrast * contrast / (3 * molecules_per_m3 * pow(wavelength_m, 4));
}

static void rayleigh_from_formula(Atmosphere *atmosphere) {
    for (int c = 0; c < 3; c++) {
        atmosphere->rayleigh_scatter_per_m[c] = atmosphere_rayleigh_formula(
            atmosphere->refractive_index, atmosphere->molecules_per_m3, atmosphere->wavelengths_nm[c] * 1e-9);
    }
}

static bool parse_field(const AtmosphereField *field, const char *value, double *target, Error *error) {
    Text range = {0};
    double parsed[3];
    for (int i = 0; i < ATMOSPHERE_WORDS && field->words[i].word; i++) {
        if (strcmp(value, field->words[i].word) != 0) continue;
        *target = field->words[i].value;
        return true;
    }
    if (!field->words[0].word) {
        return value_parse(field->name, value, field->count, field->min, field->max, target, error);
    }
    if (field->min <= field->max &&
        value_parse(field->name, value, 1, field->min, field->max, parsed, error) &&
        (!field->whole || parsed[0] == floor(parsed[0]))) {
        *target = parsed[0];
        return true;
    }
    atmosphere_print_range(field, &range);
    bool outside = field->min <= field->max && number_parse(value, parsed) &&
                   (*parsed < field->min || *parsed > field->max);
    if (outside)
        error_set(error, STATUS_USAGE, "%s: %s is outside the range from %s", field->name, value,
                  text_string(&range));
    else
        error_set(error, STATUS_USAGE, "%s: '%s' is not %s%s", field->name, value,
                  field->whole ? "a whole number from " : "", text_string(&range));
    text_free(&range);
    return false;
}

bool atmosphere_set(Atmosphere *atmosphere, const char *name, const char *value, Error *error) {
    Known known = known_to(name, strlen(name));
    for (int i = 0; atmosphere_field(i); i++) {
        const AtmosphereField *field = &fields[i];
        known_add(&known, field->name);
        if (strcmp(field->name, name) != 0) continue;
        known_free(&known);
        double *target = (double *)(void *)((char *)atmosphere + field->offset);
        if (!parse_field(field, value, target, error)) return error_prefix(error, "atmosphere.");
        if (target == atmosphere->wavelengths_nm || target == &atmosphere->refractive_index ||
            target == &atmosphere->molecules_per_m3) {
            rayleigh_from_formula(atmosphere);
        }
        return true;
    }
    for (int i = 0; known.near.name && atmosphere_field(i); i++) {
        if (known.near.name == fields[i].name) known.near.name = fields[i].setting;
    }
    return known_fail(&known, STATUS_USAGE, error, "unknown setting 'atmosphere.%s'", name);
}

bool atmosphere_check(const Atmosphere *atmosphere, Error *error) {
    if (atmosphere->top_radius_m > atmosphere->planet_radius_m) return true;
    return error_set(error, STATUS_USAGE,
                     "atmosphere.top_radius_m (%.10g) must be above atmosphere.planet_radius_m (%.10g)",
                     atmosphere->top_radius_m, atmosphere->planet_radius_m);
}
