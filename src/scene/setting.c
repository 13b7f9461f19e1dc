#include "scene/setting.h"

#include "base/known.h"
#include "scene/sun_clock.h"
#include "scene/value.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum { SIDE_LIMIT = 16384 };
static const double pixel_limit = 67108864; /* 4 GiB of film */

/* Settings that every scene has, as --set and presets name them: numbers in a range, or what a function
 * takes. */
static const struct {
    const char *name;
    size_t offset;
    int count;
    double min, max;
    bool (*take)(SceneValues *values, const char *name, const char *text, Error *error);
} common_settings[] = {
    {"sun.elevation", offsetof(SceneValues, sun.elevation_deg), 1, -90, 90, NULL},
    {"sun.azimuth", offsetof(SceneValues, sun.azimuth_deg), 1, -360, 360, NULL},
    {"sun.radius", offsetof(SceneValues, sun.radius_deg), 1, 0.01, 30, NULL},
    {"exposure", offsetof(SceneValues, exposure_ev), 1, -64, 64, NULL},
    {"time", offsetof(SceneValues, time_s), 1, 0, 1e6, NULL},
    {"mouse", offsetof(SceneValues, mouse), 4, -1e6, 1e6, NULL},
    {"camera.eye", offsetof(SceneValues, camera.eye), 3, -1e6, 1e6, NULL},
    {"camera.target", offsetof(SceneValues, camera.target), 3, -1e6, 1e6, NULL},
    {"camera.fov", offsetof(SceneValues, camera.fov_deg), 1, 0.01, 179, NULL},
    {"sun.when", 0, 1, 0, 0, sun_clock_set_when},
    {"sun.where", 0, 1, 0, 0, sun_clock_set_where},
    {"sun.north", 0, 1, 0, 0, sun_clock_set_north},
};
enum { COMMON_SETTINGS = sizeof common_settings / sizeof *common_settings };

bool scene_check_size(double width, double height, Error *error) {
    if (width >= 1 && height >= 1 && width <= SIDE_LIMIT && height <= SIDE_LIMIT &&
        width * height <= pixel_limit) {
        return true;
    }
    return error_set(
        error, STATUS_USAGE,
        "picture size %.0fx%.0f: each side must be from 1 to %d, and both together at most %.0f pixels",
        width, height, SIDE_LIMIT, pixel_limit);
}

static bool set_parameter(const Parameter *parameter, double *values, const char *value, Error *error) {
    if (parameter->type == PARAMETER_CHECKBOX) {
        bool on = strcmp(value, "1") == 0 || strcmp(value, "on") == 0 || strcmp(value, "true") == 0;
        bool off = strcmp(value, "0") == 0 || strcmp(value, "off") == 0 || strcmp(value, "false") == 0;
        if (!on && !off)
            return error_set(error, STATUS_USAGE, "%s: '%s' is not 0 or 1", parameter->name, value);
        values[0] = on;
        return true;
    }
    int count = parameter->type == PARAMETER_COLOR ? 3 : 1;
    return value_parse(parameter->name, value, count, parameter->min, parameter->max, values, error);
}

static bool set_common(SceneValues *values, int setting, const char *value, Error *error) {
    const char *name = common_settings[setting].name;
    if (common_settings[setting].take) return common_settings[setting].take(values, name, value, error);
    double *target = (double *)(void *)((char *)values + common_settings[setting].offset);
    if (!value_parse(name, value, common_settings[setting].count, common_settings[setting].min,
                     common_settings[setting].max, target, error))
        return false;
    Sun *sun = &values->sun;
    bool moved = target == &sun->elevation_deg || target == &sun->azimuth_deg;
    *sun = sun_at(sun->elevation_deg, sun->azimuth_deg, sun->radius_deg);
    if (moved) values->clock.utc_s = NAN;
    return true;
}

static int find_common(const char *name) {
    for (int i = 0; i < COMMON_SETTINGS; i++) {
        if (strcmp(common_settings[i].name, name) == 0) return i;
    }
    return -1;
}

const char *setting_common(int index) {
    return index >= 0 && index < COMMON_SETTINGS ? common_settings[index].name : NULL;
}

bool setting_is_common(const char *name) {
    return find_common(name) >= 0;
}

/* The part behind the last dot. */
static const char *last_part(const char *name) {
    const char *dot = strrchr(name, '.');
    return dot ? dot + 1 : name;
}

/* Tries the name in full, and then a name of the atmosphere or the sun from which the part in front of the
 * dot may be missing. */
static void try_setting(Near *near, Near *parts, const char **whole, const char *name) {
    const char *before = parts->name;
    near_try(near, name);
    near_try(parts, last_part(name));
    if (parts->name != before) *whole = name;
}

static bool unknown_setting(const SceneFile *file, const char *name, Error *error) {
    const char *part = last_part(name), *whole = NULL;
    Known known = known_to(name, strlen(name));
    Near parts = near_to(part, strlen(part));
    for (int i = 0; i < file->parameter_count; i++) known_add(&known, file->parameters[i].name);
    for (int i = 0; i < COMMON_SETTINGS; i++) {
        known_add(&known, common_settings[i].name);
        try_setting(&known.near, &parts, &whole, common_settings[i].name);
    }
    for (int i = 0; atmosphere_field(i); i++)
        try_setting(&known.near, &parts, &whole, atmosphere_field(i)->setting);
    text_print(&known.names, ", atmosphere.NAME");
    if (!known.near.name) known.near.name = whole;
    return known_fail(&known, STATUS_USAGE, error, "%s has no setting '%s'", file->path, name);
}

bool setting_apply(const SceneFile *file, SceneValues *values, const char *name, const char *value,
                   Error *error) {
    int common = find_common(name);
    if (strncmp(name, "atmosphere.", 11) == 0)
        return atmosphere_set(&values->atmosphere, name + 11, value, error);
    if (common >= 0) return set_common(values, common, value, error);
    for (int i = 0; i < file->parameter_count; i++) {
        if (strcmp(file->parameters[i].name, name) == 0)
            return set_parameter(&file->parameters[i], values->parameters[i], value, error);
    }
    return unknown_setting(file, name, error);
}

bool setting_choose_preset(const SceneFile *file, SceneValues *values, const char *name, Error *error) {
    Known known = known_to(name, strlen(name));
    for (int i = 0; i < file->preset_count; i++) {
        const Preset *preset = &file->presets[i];
        if (strcmp(preset->name, name) == 0) {
            known_free(&known);
            for (int s = 0; s < preset->setting_count; s++) {
                if (!setting_apply(file, values, preset->settings[s].name, preset->settings[s].value, error))
                    return false;
            }
            return true;
        }
        known_add(&known, preset->name);
    }
    return known_fail(&known, STATUS_USAGE, error, "%s has no preset '%s'", file->path, name);
}
