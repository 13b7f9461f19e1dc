#include "scene/setting.h"

#include "base/text.h"
#include "scene/value.h"

#include <stddef.h>
#include <string.h>

enum { SIDE_LIMIT = 16384 };
static const double pixel_limit = 67108864; /* 4 GiB of film */

/* Settings that every scene has, as --set and presets name them. */
static const struct {
    const char *name;
    size_t offset;
    int count;
    double min, max;
} common_settings[] = {
    {"sun.elevation", offsetof(SceneValues, sun.elevation_deg), 1, -90, 90},
    {"sun.azimuth", offsetof(SceneValues, sun.azimuth_deg), 1, -360, 360},
    {"sun.radius", offsetof(SceneValues, sun.radius_deg), 1, 0.01, 30},
    {"exposure", offsetof(SceneValues, exposure_ev), 1, -64, 64},
    {"time", offsetof(SceneValues, time_s), 1, 0, 1e6},
    {"mouse", offsetof(SceneValues, mouse), 4, -1e6, 1e6},
    {"camera.eye", offsetof(SceneValues, camera.eye), 3, -1e6, 1e6},
    {"camera.target", offsetof(SceneValues, camera.target), 3, -1e6, 1e6},
    {"camera.fov", offsetof(SceneValues, camera.fov_deg), 1, 0.01, 179},
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
    double *target = (double *)(void *)((char *)values + common_settings[setting].offset);
    if (!value_parse(name, value, common_settings[setting].count, common_settings[setting].min,
                     common_settings[setting].max, target, error))
        return false;
    Sun *sun = &values->sun;
    *sun = sun_at(sun->elevation_deg, sun->azimuth_deg, sun->radius_deg);
    return true;
}

static int find_common(const char *name) {
    for (int i = 0; i < COMMON_SETTINGS; i++) {
        if (strcmp(common_settings[i].name, name) == 0) return i;
    }
    return -1;
}

bool setting_is_common(const char *name) {
    return find_common(name) >= 0;
}

static bool unknown_setting(const SceneFile *file, const char *name, Error *error) {
    Text known = {0};
    for (int i = 0; i < file->parameter_count; i++) text_print(&known, "%s, ", file->parameters[i].name);
    for (int i = 0; i < COMMON_SETTINGS; i++) text_print(&known, "%s, ", common_settings[i].name);
    error_set(error, STATUS_USAGE, "%s has no setting '%s' (known: %satmosphere.NAME)", file->path, name,
              text_string(&known));
    text_free(&known);
    return false;
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
    Text known = {0};
    for (int i = 0; i < file->preset_count; i++) {
        const Preset *preset = &file->presets[i];
        if (strcmp(preset->name, name) == 0) {
            text_free(&known);
            for (int s = 0; s < preset->setting_count; s++) {
                if (!setting_apply(file, values, preset->settings[s].name, preset->settings[s].value, error))
                    return false;
            }
            return true;
        }
        text_print(&known, "%s%s", i ? ", " : "", preset->name);
    }
    error_set(error, STATUS_USAGE, "%s has no preset '%s' (known: %s)", file->path, name,
              known.size ? text_string(&known) : "none");
    text_free(&known);
    return false;
}
