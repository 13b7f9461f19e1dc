#include "scene/scene.h"

#include "base/memory.h"
#include "base/number.h"
#include "base/text.h"
#include "scene/annotation.h"
#include "scene/value.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
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

static SceneFile *create_file(const char *path) {
    SceneFile *file = memory_get(1, sizeof *file);
    *file = (SceneFile){.path = strdup(path),
                        .width = 512,
                        .height = 512,
                        .values = {.camera = {.eye = {0, 2, -4}, .fov_deg = 90},
                                   .sun = sun_at(30, 0, 0.2666),
                                   .atmosphere = atmosphere_preset(0)->atmosphere},
                        .users = 1};
    return file;
}

Scene scene_default(const char *path) {
    const SceneFile *file = create_file(path);
    return (Scene){file, file->values};
}

bool scene_read(Scene *scene, const char *path, Error *error) {
    SceneFile *file = create_file(path);
    bool ok = annotation_read(file, error);
    if (!ok) scene_file_release(file);
    *scene = ok ? (Scene){file, file->values} : (Scene){0};
    return ok;
}

void scene_destroy(Scene *scene) {
    scene_file_release(scene->file);
    *scene = (Scene){0};
}

Scene scene_share(const Scene *scene) {
    Scene copy = *scene;
    if (copy.file) scene_file_share(copy.file);
    return copy;
}

bool scene_same(const Scene *a, const Scene *b) {
    return a->file == b->file && scene_values_same(&a->values, &b->values);
}

void scene_set_sun(Scene *scene, double elevation_deg, double azimuth_deg) {
    scene->values.sun = sun_at(elevation_deg, azimuth_deg, scene->values.sun.radius_deg);
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

bool scene_set(Scene *scene, const char *name, const char *value, Error *error) {
    const SceneFile *file = scene->file;
    if (strncmp(name, "atmosphere.", 11) == 0)
        return atmosphere_set(&scene->values.atmosphere, name + 11, value, error);
    for (int i = 0; i < COMMON_SETTINGS; i++) {
        if (strcmp(common_settings[i].name, name) == 0) return set_common(&scene->values, i, value, error);
    }
    Text known = {0};
    for (int i = 0; i < file->parameter_count; i++) {
        if (strcmp(file->parameters[i].name, name) == 0) {
            text_free(&known);
            return set_parameter(&file->parameters[i], scene->values.parameters[i], value, error);
        }
        text_print(&known, "%s, ", file->parameters[i].name);
    }
    for (int i = 0; i < COMMON_SETTINGS; i++) text_print(&known, "%s, ", common_settings[i].name);
    error_set(error, STATUS_USAGE, "%s has no setting '%s' (known: %satmosphere.NAME)", file->path, name,
              text_string(&known));
    text_free(&known);
    return false;
}

bool scene_choose_preset(Scene *scene, const char *name, Error *error) {
    Text known = {0};
    for (int i = 0; i < scene->file->preset_count; i++) {
        const Preset *preset = &scene->file->presets[i];
        if (strcmp(preset->name, name) == 0) {
            text_free(&known);
            for (int s = 0; s < preset->setting_count; s++) {
                if (!scene_set(scene, preset->settings[s].name, preset->settings[s].value, error))
                    return false;
            }
            return true;
        }
        text_print(&known, "%s%s", i ? ", " : "", preset->name);
    }
    error_set(error, STATUS_USAGE, "%s has no preset '%s' (known: %s)", scene->file->path, name,
              known.size ? text_string(&known) : "none");
    text_free(&known);
    return false;
}

/* A word of a hint: a number, or a slider's value, with the minus that may stand before its name. */
static double number_of(const Scene *scene, const char *word) {
    const SceneFile *file = scene->file;
    bool minus = *word == '-';
    double number;
    if (number_parse(word, &number)) return number;
    for (int i = 0; i < file->parameter_count; i++) {
        if (strcmp(file->parameters[i].name, word + minus) != 0) continue;
        double value = scene->values.parameters[i][0];
        return minus ? -value : value;
    }
    return 0;
}

int scene_hint_count(const Scene *scene, HintKind kind) {
    return scene->values.ignored_hints & 1U << kind ? 0 : scene->file->hints[kind].count;
}

void scene_hint(const Scene *scene, HintKind kind, int index, double out[4]) {
    const Hint *hint = &scene->file->hints[kind].list[index];
    for (int i = 0; i < 4; i++)
        out[i] = i < hint_info(kind)->components ? number_of(scene, hint->words[i]) : 0;
}

int scene_sphere_count(const Scene *scene) {
    const SceneFile *file = scene->file;
    double number;
    if (number_parse(file->spheres, &number)) return (int)number;
    for (int i = 0; i < file->parameter_count; i++) {
        if (strcmp(file->parameters[i].name, file->spheres) == 0) return (int)scene->values.parameters[i][0];
    }
    return -1;
}

char *scene_sphere_path(const Scene *scene) {
    const char *folder = scene->file->path, *name = scene->file->spheres, *slash = strrchr(folder, '/');
    Text path = {0};
    if (slash && name[0] != '/') text_append(&path, folder, (size_t)(slash - folder) + 1);
    text_print(&path, "%s", name);
    return path.data;
}

bool scene_check(const Scene *scene, Error *error) {
    const double *eye = scene->values.camera.eye, *target = scene->values.camera.target;
    double distance = hypot(hypot(target[0] - eye[0], target[1] - eye[1]), target[2] - eye[2]);
    if (distance < 1e-6)
        return error_set(error, STATUS_USAGE, "%s: the camera's eye is at its target", scene->file->path);
    return atmosphere_check(&scene->values.atmosphere, error);
}
