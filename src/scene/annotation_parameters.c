#include "scene/annotation_parameters.h"

#include "base/known.h"
#include "base/memory.h"
#include "scene/host_names.h"
#include "scene/setting.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A parameter is set by its name and told to all programs by its name: it must be no one else's. */
static bool is_free(const SceneFile *file, const char *name, Error *error) {
    char path[256];
    if (setting_is_common(name)) {
        return error_set(
            error, STATUS_SCENE,
            "uniform '%s': every scene has a setting of that name, so that --set could not tell them apart",
            name);
    }
    if (!host_names_find(file->sources, name, path, sizeof path)) return true;
    return error_set(error, STATUS_SCENE, "uniform '%s': the host has a uniform of that name (%s)", name,
                     path);
}

/* A new parameter. */
static Parameter *add(SceneFile *file, const char *name, Error *error) {
    for (int i = 0; i < file->parameter_count; i++) {
        if (strcmp(file->parameters[i].name, name) == 0) {
            error_set(error, STATUS_SCENE, "uniform '%s' is declared twice", name);
            return NULL;
        }
    }
    if (file->parameter_count == (int)(sizeof file->parameters / sizeof *file->parameters)) {
        error_set(error, STATUS_SCENE, "more than %d parameters", file->parameter_count);
        return NULL;
    }
    Parameter *parameter = &file->parameters[file->parameter_count++];
    *parameter = (Parameter){.max = 1, .unit = memory_string(""), .label = memory_string("")};
    snprintf(parameter->name, sizeof parameter->name, "%s", name);
    return parameter;
}

/* The parameter declared on the annotation's own line as `uniform TYPE NAME;`. */
static Parameter *declared(Line *line, const char *type, Error *error) {
    SceneFile *file = line->file;
    char found[64], name[64];
    int used = 0;
    if (sscanf(line->declaration, " uniform %63[a-z0-9A-Z] %63[A-Za-z0-9_] ; %n", found, name, &used) != 2 ||
        !used || line->declaration[used]) {
        error_set(error, STATUS_SCENE, "%s stands behind `uniform %s NAME;` on the same line", line->words[0],
                  type);
        return NULL;
    }
    if (strcmp(found, type) != 0) {
        error_set(error, STATUS_SCENE, "%s needs a uniform of type %s, '%s' is a %s", line->words[0], type,
                  name, found);
        return NULL;
    }
    return is_free(file, name, error) ? add(file, name, error) : NULL;
}

static double *value_of(const Line *line, const Parameter *parameter) {
    return line->file->values.parameters[parameter - line->file->parameters];
}

/* Only a slider has a range. */
static bool unknown_key(const Line *line, int at, Error *error) {
    static const char *const keys[] = {"unit", "label", "min", "max"};
    int count = strcmp(line->words[0], "slider") == 0 ? 4 : 2;
    Known known = known_to(line->words[at], strlen(line->words[at]));
    for (int i = 0; i < count; i++) known_add(&known, keys[i]);
    return known_fail(&known, STATUS_SCENE, error, "%s: unknown key '%s'", line->words[0], line->words[at]);
}

/* Whether the key does not stand in front of its place too: keys have even places. */
static bool key_once(const Line *line, int at, Error *error) {
    for (int i = 2; i < at; i += 2) {
        if (strcmp(line->words[i], line->words[at]) == 0)
            return error_set(error, STATUS_SCENE, "%s: %s is there twice", line->words[0], line->words[at]);
    }
    return true;
}

/* The trailing `unit m label "height of the ball"`. */
static bool read_words(const Line *line, int at, Parameter *parameter, Error *error) {
    for (; at < line->count; at += 2) {
        bool unit = strcmp(line->words[at], "unit") == 0;
        if (!unit && strcmp(line->words[at], "label") != 0) {
            return unknown_key(line, at, error);
        }
        if (at + 1 == line->count) return error_set(error, STATUS_SCENE, "%s needs a word", line->words[at]);
        if (!key_once(line, at, error)) return false;
        char **target = unit ? &parameter->unit : &parameter->label;
        free(*target);
        *target = memory_string(line->words[at + 1]);
    }
    return true;
}

bool parameters_read_slider(Line *line, Error *error) {
    Parameter *parameter = declared(line, "float", error);
    if (!parameter || !line_numbers(line, 1, 1, -1e30, 1e30, value_of(line, parameter), error)) return false;
    parameter->type = PARAMETER_SLIDER;
    int at = 2;
    for (; at < line->count; at += 2) {
        bool min = strcmp(line->words[at], "min") == 0;
        if (!min && strcmp(line->words[at], "max") != 0) break;
        if (!key_once(line, at, error)) return false;
        if (!line_numbers(line, at + 1, 1, -1e30, 1e30, min ? &parameter->min : &parameter->max, error))
            return false;
    }
    if (!read_words(line, at, parameter, error)) return false;
    if (value_of(line, parameter)[0] < parameter->min || value_of(line, parameter)[0] > parameter->max) {
        return error_set(error, STATUS_SCENE, "slider: %g is outside the range from %g to %g",
                         value_of(line, parameter)[0], parameter->min, parameter->max);
    }
    return true;
}

bool parameters_read_checkbox(Line *line, Error *error) {
    Parameter *parameter = declared(line, "bool", error);
    if (!parameter) return false;
    parameter->type = PARAMETER_CHECKBOX;
    bool on = line->count > 1 && strcmp(line->words[1], "on") == 0;
    if (!on && (line->count < 2 || strcmp(line->words[1], "off") != 0)) {
        return error_set(error, STATUS_SCENE, "checkbox needs on or off");
    }
    value_of(line, parameter)[0] = on;
    return read_words(line, 2, parameter, error);
}

bool parameters_read_color(Line *line, Error *error) {
    Parameter *parameter = declared(line, "vec3", error);
    if (!parameter || !line_numbers(line, 1, 3, 0, 1, value_of(line, parameter), error)) return false;
    parameter->type = PARAMETER_COLOR;
    return read_words(line, 4, parameter, error);
}

int parameters_add_switch(SceneFile *file, const char *name, const char *label, Error *error) {
    Parameter *parameter = add(file, name, error);
    if (!parameter) return -1;
    parameter->type = PARAMETER_CHECKBOX;
    free(parameter->label);
    parameter->label = memory_string(label);
    int number = (int)(parameter - file->parameters);
    file->values.parameters[number][0] = 1;
    return number;
}

const Parameter *parameters_find_slider(const SceneFile *file, const char *name) {
    for (int i = 0; i < file->parameter_count; i++) {
        const Parameter *parameter = &file->parameters[i];
        if (parameter->type == PARAMETER_SLIDER && strcmp(parameter->name, name) == 0) return parameter;
    }
    return NULL;
}
