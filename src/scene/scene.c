#include "scene/scene.h"

#include "base/text.h"
#include "scene/annotation.h"
#include "scene/value.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
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
    {"sun.elevation", offsetof(Scene, sun_elevation_deg), 1, -90, 90},
    {"sun.azimuth", offsetof(Scene, sun_azimuth_deg), 1, -360, 360},
    {"sun.radius", offsetof(Scene, sun_radius_deg), 1, 0.01, 30},
    {"exposure", offsetof(Scene, exposure_ev), 1, -64, 64},
    {"time", offsetof(Scene, time_s), 1, 0, 1e6},
    {"camera.eye", offsetof(Scene, eye), 3, -1e6, 1e6},
    {"camera.target", offsetof(Scene, target), 3, -1e6, 1e6},
    {"camera.fov", offsetof(Scene, fov_deg), 1, 0.01, 179},
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

Scene scene_default(const char *path) {
    return (Scene){.path = strdup(path),
                   .eye = {0, 2, -4},
                   .fov_deg = 90,
                   .sun_elevation_deg = 30,
                   .sun_radius_deg = 0.2666,
                   .width = 512,
                   .height = 512,
                   .atmosphere = atmosphere_preset(0)->atmosphere};
}

bool scene_read(Scene *scene, const char *path, Error *error) {
    *scene = scene_default(path);
    if (annotation_read(scene, error)) return true;
    scene_destroy(scene);
    return false;
}

void scene_destroy(Scene *scene) {
    free(scene->path);
    *scene = (Scene){0};
}

static bool set_parameter(Parameter *parameter, const char *value, Error *error) {
    if (parameter->type == PARAMETER_CHECKBOX) {
        bool on = strcmp(value, "1") == 0 || strcmp(value, "on") == 0 || strcmp(value, "true") == 0;
        bool off = strcmp(value, "0") == 0 || strcmp(value, "off") == 0 || strcmp(value, "false") == 0;
        if (!on && !off)
            return error_set(error, STATUS_USAGE, "%s: '%s' is not 0 or 1", parameter->name, value);
        parameter->value[0] = on;
        return true;
    }
    int count = parameter->type == PARAMETER_COLOR ? 3 : 1;
    return value_parse(parameter->name, value, count, parameter->min, parameter->max, parameter->value,
                       error);
}

bool scene_set(Scene *scene, const char *name, const char *value, Error *error) {
    if (strncmp(name, "atmosphere.", 11) == 0)
        return atmosphere_set(&scene->atmosphere, name + 11, value, error);
    for (int i = 0; i < COMMON_SETTINGS; i++) {
        if (strcmp(common_settings[i].name, name) != 0) continue;
        double *target = (double *)(void *)((char *)scene + common_settings[i].offset);
        return value_parse(name, value, common_settings[i].count, common_settings[i].min,
                           common_settings[i].max, target, error);
    }
    Text known = {0};
    for (int i = 0; i < scene->parameter_count; i++) {
        if (strcmp(scene->parameters[i].name, name) == 0) {
            text_free(&known);
            return set_parameter(&scene->parameters[i], value, error);
        }
        text_print(&known, "%s, ", scene->parameters[i].name);
    }
    for (int i = 0; i < COMMON_SETTINGS; i++) text_print(&known, "%s, ", common_settings[i].name);
    error_set(error, STATUS_USAGE, "%s has no setting '%s' (known: %satmosphere.NAME)", scene->path, name,
              text_string(&known));
    text_free(&known);
    return false;
}

bool scene_choose_preset(Scene *scene, const char *name, Error *error) {
    Text known = {0};
    for (int i = 0; i < scene->preset_count; i++) {
        const Preset *preset = &scene->presets[i];
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
    error_set(error, STATUS_USAGE, "%s has no preset '%s' (known: %s)", scene->path, name,
              known.size ? text_string(&known) : "none");
    text_free(&known);
    return false;
}

void scene_sphere(const Scene *scene, const NamedSphere *sphere, double out[4]) {
    for (int i = 0; i < 4; i++) {
        if (number_parse(sphere->words[i], &out[i])) continue;
        for (int k = 0; k < scene->parameter_count; k++) {
            if (strcmp(scene->parameters[k].name, sphere->words[i]) == 0)
                out[i] = scene->parameters[k].value[0];
        }
    }
}

int scene_sphere_count(const Scene *scene) {
    double number;
    if (number_parse(scene->spheres, &number)) return (int)number;
    for (int i = 0; i < scene->parameter_count; i++) {
        if (strcmp(scene->parameters[i].name, scene->spheres) == 0) return (int)scene->parameters[i].value[0];
    }
    return -1;
}

char *scene_sphere_path(const Scene *scene) {
    const char *slash = strrchr(scene->path, '/');
    Text path = {0};
    if (slash && scene->spheres[0] != '/') text_append(&path, scene->path, (size_t)(slash - scene->path) + 1);
    text_print(&path, "%s", scene->spheres);
    return path.data;
}

bool scene_check(const Scene *scene, Error *error) {
    double distance = hypot(hypot(scene->target[0] - scene->eye[0], scene->target[1] - scene->eye[1]),
                            scene->target[2] - scene->eye[2]);
    if (distance < 1e-6)
        return error_set(error, STATUS_USAGE, "%s: the camera's eye is at its target", scene->path);
    return atmosphere_check(&scene->atmosphere, error);
}
