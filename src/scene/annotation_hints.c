#include "scene/annotation_hints.h"

#include "base/number.h"
#include "base/text.h"
#include "scene/annotation_parameters.h"

#include <string.h>

bool hints_know(const Line *line, HintKind *kind) {
    for (int i = 0; i < HINT_KINDS; i++) {
        *kind = (HintKind)i;
        if (strcmp(hint_info(*kind)->key, line->words[0]) == 0) return true;
    }
    return false;
}

bool hints_read(Line *line, HintKind kind, Error *error) {
    const HintInfo *info = hint_info(kind);
    HintList *hints = &line->file->hints[kind];
    if (line->count != 1 + info->components)
        return error_set(error, STATUS_SCENE, "%s needs %s", info->key, info->needs);
    if (hints->count == MOST_HINTS)
        return error_set(error, STATUS_SCENE, "%s more than %d times", info->key, MOST_HINTS);
    Hint *hint = &hints->list[hints->count++];
    hint->line = line->number;
    for (int i = 0; i < info->components; i++) {
        if (!line_copy_word(hint->words[i], sizeof hint->words[i], line->words[1 + i], error)) return false;
    }
    return true;
}

static bool is_file(const char *word) {
    size_t length = strlen(word);
    return length > 4 && strcmp(word + length - 4, ".csv") == 0;
}

bool hints_name_file(const SceneFile *file) {
    return is_file(file->spheres);
}

bool hints_read_spheres(Line *line, Error *error) {
    SceneFile *file = line->file;
    double number;
    if (line->count != 2)
        return error_set(error, STATUS_SCENE, "spheres needs a number, a slider's name or a .csv file");
    const char *word = line->words[1];
    if (number_parse(word, &number)) {
        if (number < 0 || number > SCENE_MOST_SPHERES)
            return error_set(error, STATUS_SCENE, "spheres: %s is outside the range from 0 to %d", word,
                             SCENE_MOST_SPHERES);
        if (number != (double)(int)number)
            return error_set(error, STATUS_SCENE, "spheres: '%s' is not a whole number", word);
    }
    file->spheres_line = line->number;
    return line_copy_word(file->spheres, sizeof file->spheres, word, error);
}

/* A hint may be named by sliders declared below it too. */
static bool check_hints(const SceneFile *file, HintKind kind, Error *error) {
    const HintInfo *info = hint_info(kind);
    for (int i = 0; i < file->hints[kind].count * info->components; i++) {
        const Hint *hint = &file->hints[kind].list[i / info->components];
        int component = i % info->components;
        const char *word = hint->words[component];
        bool length = component >= info->lengths_from;
        double number;
        if (parameters_find_slider(file, word + (*word == '-' && !length)) ||
            (number_parse(word, &number) && (!length || number > 0)))
            continue;
        return error_set(error, STATUS_SCENE, "%s:%d: %s: '%s' is neither a %s nor a slider's name",
                         file->path, hint->line, info->key, word, length ? "number above 0" : "number");
    }
    return true;
}

static bool check_many_spheres(const SceneFile *file, Error *error) {
    const char *word = file->spheres;
    double number;
    if (!word[0] || number_parse(word, &number) || is_file(word)) return true;
    const Parameter *slider = parameters_find_slider(file, word);
    if (!slider) {
        return error_set(error, STATUS_SCENE,
                         "%s:%d: spheres: '%s' is neither a number, a slider's name nor a .csv file",
                         file->path, file->spheres_line, word);
    }
    if (slider->min >= 0 && slider->max <= SCENE_MOST_SPHERES) return true;
    return error_set(error, STATUS_SCENE, "%s:%d: spheres: the slider '%s' goes from %g to %g, past 0 to %d",
                     file->path, file->spheres_line, word, slider->min, slider->max, SCENE_MOST_SPHERES);
}

bool hints_check(const SceneFile *file, Error *error) {
    for (int kind = 0; kind < HINT_KINDS; kind++) {
        if (!check_hints(file, (HintKind)kind, error)) return false;
    }
    return check_many_spheres(file, error);
}
