#include "scene/annotation.h"

#include "base/file.h"
#include "base/number.h"
#include "scene/glsl_source.h"
#include "scene/scene.h"
#include "scene/value.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum { MOST_WORDS = 40 };

/* One annotation, cut into words; words[0] is its key. */
typedef struct Line {
    SceneFile *file;
    char *words[MOST_WORDS];
    int count;
    char *declaration; /* the GLSL before the annotation on the same line */
    int number;
} Line;

static bool cut_words(Line *line, char *text, Error *error) {
    line->count = 0;
    for (text += strspn(text, " \t\r"); *text; text += strspn(text, " \t\r")) {
        if (line->count == MOST_WORDS)
            return error_set(error, STATUS_SCENE, "more than %d words", MOST_WORDS);
        char *end;
        if (*text == '"') {
            end = strchr(++text, '"');
            if (!end) return error_set(error, STATUS_SCENE, "the quotation mark is not closed");
        } else {
            end = text + strcspn(text, " \t\r");
        }
        line->words[line->count++] = text;
        text = end + (*end != 0);
        *end = 0;
    }
    return true;
}

static void join_words(const Line *line, int first, char *out, size_t size) {
    size_t used = 0;
    out[0] = 0;
    for (int i = first; i < line->count && used < size; i++) {
        used += (size_t)snprintf(out + used, size - used, "%s%s", i > first ? " " : "", line->words[i]);
    }
}

/* A word that must fit: cutting it short would make it another. */
static bool copy_word(char *target, size_t size, const char *word, Error *error) {
    if (strlen(word) >= size)
        return error_set(error, STATUS_SCENE, "'%s' has more than %zu characters", word, size - 1);
    memcpy(target, word, strlen(word) + 1);
    return true;
}

/* words[at .. at+count) as numbers in a range. */
static bool numbers(const Line *line, int at, int count, double min, double max, double *values,
                    Error *error) {
    for (int i = 0; i < count; i++) {
        if (at + i >= line->count) {
            return error_set(error, STATUS_SCENE, "%s needs %d number%s", line->words[at - 1], count,
                             count > 1 ? "s" : "");
        }
        if (!number_parse_range(line->words[at - 1], line->words[at + i], min, max, &values[i], error))
            return false;
    }
    return true;
}

/* A table of "key numbers" pairs in any order, as in `camera eye 0 2 -4 fov 90`. */
typedef struct Key {
    const char *name;
    int count;
    double min, max;
    double *values;
} Key;

static bool keys(const Line *line, int at, const Key *table, int entries, Error *error) {
    while (at < line->count) {
        const Key *key = NULL;
        for (int i = 0; i < entries; i++) {
            if (strcmp(table[i].name, line->words[at]) == 0) key = &table[i];
        }
        if (!key)
            return error_set(error, STATUS_SCENE, "%s: unknown key '%s'", line->words[0], line->words[at]);
        if (!numbers(line, at + 1, key->count, key->min, key->max, key->values, error)) return false;
        at += 1 + key->count;
    }
    return true;
}

static bool read_title(Line *line, Error *error) {
    (void)error;
    join_words(line, 1, line->file->title, sizeof line->file->title);
    return true;
}

static bool read_look(Line *line, Error *error) {
    (void)error;
    join_words(line, 1, line->file->look, sizeof line->file->look);
    return true;
}

static bool read_camera(Line *line, Error *error) {
    SceneFile *file = line->file;
    const Key table[] = {{"eye", 3, -1e6, 1e6, file->values.camera.eye},
                         {"target", 3, -1e6, 1e6, file->values.camera.target},
                         {"fov", 1, 0.01, 179, &file->values.camera.fov_deg}};
    return keys(line, 1, table, 3, error);
}

static bool read_sun(Line *line, Error *error) {
    const Key table[] = {{"elevation", 1, -90, 90, &line->file->values.sun.elevation_deg},
                         {"azimuth", 1, -360, 360, &line->file->values.sun.azimuth_deg},
                         {"radius", 1, 0.01, 30, &line->file->values.sun.radius_deg}};
    if (!keys(line, 1, table, 3, error)) return false;
    Sun *sun = &line->file->values.sun;
    *sun = sun_at(sun->elevation_deg, sun->azimuth_deg, sun->radius_deg);
    return true;
}

static bool read_sun_disk(Line *line, Error *error) {
    bool on = line->count == 2 && strcmp(line->words[1], "on") == 0;
    if (!on && (line->count != 2 || strcmp(line->words[1], "off") != 0))
        return error_set(error, STATUS_SCENE, "sun-disk needs on or off");
    line->file->values.sun_disk = on;
    return true;
}

static bool read_exposure(Line *line, Error *error) {
    return numbers(line, 1, 1, -64, 64, &line->file->values.exposure_ev, error);
}

static bool read_size(Line *line, Error *error) {
    double size[2];
    if (!numbers(line, 1, 2, 0, 1e9, size, error) || !scene_check_size(size[0], size[1], error)) return false;
    if (size[0] != (int)size[0] || size[1] != (int)size[1]) {
        return error_set(error, STATUS_SCENE, "size needs two whole numbers");
    }
    line->file->width = (int)size[0];
    line->file->height = (int)size[1];
    return true;
}

static bool read_sky(Line *line, Error *error) {
    if (line->count != 2) return error_set(error, STATUS_SCENE, "sky needs a method, such as uniform:1");
    line->file->sky_line = line->number;
    return copy_word(line->file->sky, sizeof line->file->sky, line->words[1], error);
}

static bool read_atmosphere(Line *line, Error *error) {
    if (line->count != 2) return error_set(error, STATUS_SCENE, "atmosphere needs a preset's name");
    return atmosphere_choose(&line->file->values.atmosphere, line->words[1], error);
}

static bool read_preset(Line *line, Error *error) {
    SceneFile *file = line->file;
    enum { MOST = sizeof file->presets / sizeof *file->presets };
    if (line->count < 2 || line->count % 2) {
        return error_set(error, STATUS_SCENE, "preset needs a name and pairs of setting and value");
    }
    if (file->preset_count == MOST) return error_set(error, STATUS_SCENE, "more than %d presets", MOST);
    Preset *preset = &file->presets[file->preset_count++];
    *preset = (Preset){.line = line->number};
    if (!copy_word(preset->name, sizeof preset->name, line->words[1], error)) return false;
    for (int i = 0; i + 1 < file->preset_count; i++) {
        if (strcmp(file->presets[i].name, preset->name) == 0) {
            return error_set(error, STATUS_SCENE, "preset '%s' is there already", preset->name);
        }
    }
    for (int i = 2; i < line->count; i += 2) {
        if (preset->setting_count == (int)(sizeof preset->settings / sizeof *preset->settings)) {
            return error_set(error, STATUS_SCENE, "preset %s has too many settings", preset->name);
        }
        Setting *setting = &preset->settings[preset->setting_count++];
        if (!copy_word(setting->name, sizeof setting->name, line->words[i], error) ||
            !copy_word(setting->value, sizeof setting->value, line->words[i + 1], error)) {
            return false;
        }
    }
    return true;
}

static bool read_hint(Line *line, HintKind kind, Error *error) {
    const HintInfo *info = hint_info(kind);
    HintList *hints = &line->file->hints[kind];
    if (line->count != 1 + info->components)
        return error_set(error, STATUS_SCENE, "%s needs %s", info->key, info->needs);
    if (hints->count == MOST_HINTS)
        return error_set(error, STATUS_SCENE, "%s more than %d times", info->key, MOST_HINTS);
    Hint *hint = &hints->list[hints->count++];
    hint->line = line->number;
    for (int i = 0; i < info->components; i++) {
        if (!copy_word(hint->words[i], sizeof hint->words[i], line->words[1 + i], error)) return false;
    }
    return true;
}

static bool read_bound(Line *line, Error *error) {
    return read_hint(line, HINT_BOUND, error);
}

static bool read_mirror_sphere(Line *line, Error *error) {
    return read_hint(line, HINT_MIRROR_SPHERE, error);
}

static bool read_mirror_plane(Line *line, Error *error) {
    return read_hint(line, HINT_MIRROR_PLANE, error);
}

static bool read_emitter_sphere(Line *line, Error *error) {
    return read_hint(line, HINT_EMITTER_SPHERE, error);
}

static bool is_file(const char *word) {
    size_t length = strlen(word);
    return length > 4 && strcmp(word + length - 4, ".csv") == 0;
}

static bool read_many_spheres(Line *line, Error *error) {
    SceneFile *file = line->file;
    double number;
    if (line->count != 2)
        return error_set(error, STATUS_SCENE, "spheres needs a number, a slider's name or a .csv file");
    const char *word = line->words[1];
    if (file->spheres[0]) return error_set(error, STATUS_SCENE, "spheres is there already");
    if (number_parse(word, &number) &&
        (number < 0 || number > SCENE_MOST_SPHERES || number != (double)(int)number)) {
        return error_set(error, STATUS_SCENE, "spheres: '%s' is not a whole number from 0 to %d", word,
                         SCENE_MOST_SPHERES);
    }
    file->spheres_line = line->number;
    return copy_word(file->spheres, sizeof file->spheres, word, error);
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
    *parameter = (Parameter){.max = 1};
    snprintf(parameter->name, sizeof parameter->name, "%s", name);
    return parameter;
}

static double *value_of(const Line *line, const Parameter *parameter) {
    return line->file->values.parameters[parameter - line->file->parameters];
}

/* The trailing `unit m label "height of the ball"`. */
static bool read_words(const Line *line, int at, Parameter *parameter, Error *error) {
    for (; at < line->count; at += 2) {
        bool unit = strcmp(line->words[at], "unit") == 0;
        if (!unit && strcmp(line->words[at], "label") != 0) {
            return error_set(error, STATUS_SCENE, "%s: unknown key '%s'", line->words[0], line->words[at]);
        }
        if (at + 1 == line->count) return error_set(error, STATUS_SCENE, "%s needs a word", line->words[at]);
        if (unit) snprintf(parameter->unit, sizeof parameter->unit, "%s", line->words[at + 1]);
        if (!unit) snprintf(parameter->label, sizeof parameter->label, "%s", line->words[at + 1]);
    }
    return true;
}

static bool read_slider(Line *line, Error *error) {
    Parameter *parameter = declared(line, "float", error);
    if (!parameter || !numbers(line, 1, 1, -1e30, 1e30, value_of(line, parameter), error)) return false;
    parameter->type = PARAMETER_SLIDER;
    int at = 2;
    for (; at < line->count; at += 2) {
        bool min = strcmp(line->words[at], "min") == 0;
        if (!min && strcmp(line->words[at], "max") != 0) break;
        if (!numbers(line, at + 1, 1, -1e30, 1e30, min ? &parameter->min : &parameter->max, error))
            return false;
    }
    if (!read_words(line, at, parameter, error)) return false;
    if (value_of(line, parameter)[0] < parameter->min || value_of(line, parameter)[0] > parameter->max) {
        return error_set(error, STATUS_SCENE, "slider: %g is not from %g to %g", value_of(line, parameter)[0],
                         parameter->min, parameter->max);
    }
    return true;
}

static bool read_checkbox(Line *line, Error *error) {
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

static bool read_color(Line *line, Error *error) {
    Parameter *parameter = declared(line, "vec3", error);
    if (!parameter || !numbers(line, 1, 3, 0, 1, value_of(line, parameter), error)) return false;
    parameter->type = PARAMETER_COLOR;
    return read_words(line, 4, parameter, error);
}

static const struct {
    const char *key;
    bool (*read)(Line *line, Error *error);
} annotations[] = {
    {"title", read_title},
    {"look", read_look},
    {"camera", read_camera},
    {"sun", read_sun},
    {"size", read_size},
    {"exposure", read_exposure},
    {"sky", read_sky},
    {"atmosphere", read_atmosphere},
    {"preset", read_preset},
    {"bound", read_bound},
    {"sun-disk", read_sun_disk},
    {"mirror-sphere", read_mirror_sphere},
    {"mirror-plane", read_mirror_plane},
    {"slider", read_slider},
    {"checkbox", read_checkbox},
    {"color", read_color},
    {"spheres", read_many_spheres},
    {"emitter-sphere", read_emitter_sphere},
};
enum { ANNOTATIONS = sizeof annotations / sizeof *annotations };

static bool read_annotation(Line *line, Error *error) {
    if (!line->count) return error_set(error, STATUS_SCENE, "an annotation needs a key");
    for (int i = 0; i < ANNOTATIONS; i++) {
        if (strcmp(annotations[i].key, line->words[0]) == 0) return annotations[i].read(line, error);
    }
    Text known = {0};
    for (int i = 0; i < ANNOTATIONS; i++) text_print(&known, "%s%s", i ? ", " : "", annotations[i].key);
    error_set(error, STATUS_SCENE, "unknown annotation '%s' (known: %s)", line->words[0],
              text_string(&known));
    text_free(&known);
    return false;
}

static bool read_line(SceneFile *file, char *text, int number, Error *error) {
    char *mark = strstr(text, "//@");
    char *comment = strstr(text, "//");
    if (!mark || comment != mark) return true;
    *mark = 0;
    Line line = {.file = file, .declaration = text, .number = number};
    if (cut_words(&line, mark + 3, error) && read_annotation(&line, error)) return true;
    error->status = STATUS_SCENE;
    return error_prefix(error, "%s:%d: ", file->path, number);
}

/* A preset's settings may name parameters declared below it, so all are tried at the end, on a copy. */
static bool try_presets(const SceneFile *file, Error *error) {
    for (int i = 0; i < file->preset_count; i++) {
        Scene trial = {file, file->values};
        if (!scene_choose_preset(&trial, file->presets[i].name, error)) {
            error->status = STATUS_SCENE;
            return error_prefix(error, "%s:%d: ", file->path, file->presets[i].line);
        }
    }
    return true;
}

static const Parameter *find_slider(const SceneFile *file, const char *name) {
    for (int i = 0; i < file->parameter_count; i++) {
        const Parameter *parameter = &file->parameters[i];
        if (parameter->type == PARAMETER_SLIDER && strcmp(parameter->name, name) == 0) return parameter;
    }
    return NULL;
}

/* A hint may be named by sliders declared below it too. */
static bool check_hints(const SceneFile *file, HintKind kind, Error *error) {
    const HintInfo *info = hint_info(kind);
    for (int i = 0; i < file->hints[kind].count * info->components; i++) {
        const Hint *hint = &file->hints[kind].list[i / info->components];
        int component = i % info->components;
        const char *word = hint->words[component];
        bool radius = component == 3;
        double number;
        if (find_slider(file, word + (*word == '-' && !radius)) ||
            (number_parse(word, &number) && (!radius || number > 0)))
            continue;
        return error_set(error, STATUS_SCENE, "%s:%d: %s: '%s' is neither a %s nor a slider's name",
                         file->path, hint->line, info->key, word, radius ? "number above 0" : "number");
    }
    return true;
}

static bool check_many_spheres(const SceneFile *file, Error *error) {
    const char *word = file->spheres;
    double number;
    if (!word[0] || number_parse(word, &number) || is_file(word)) return true;
    const Parameter *slider = find_slider(file, word);
    if (!slider) {
        return error_set(error, STATUS_SCENE,
                         "%s:%d: spheres: '%s' is neither a number, a slider's name nor a .csv file",
                         file->path, file->spheres_line, word);
    }
    if (slider->min >= 0 && slider->max <= SCENE_MOST_SPHERES) return true;
    return error_set(error, STATUS_SCENE, "%s:%d: spheres: the slider '%s' goes from %g to %g, past 0 to %d",
                     file->path, file->spheres_line, word, slider->min, slider->max, SCENE_MOST_SPHERES);
}

bool annotation_read(SceneFile *file, Error *error) {
    Text text = {0};
    if (!file_read(file->path, STATUS_SCENE, &text, error)) {
        text_free(&text);
        return false;
    }
    text_append(&text, "", 0);
    int number = 1;
    bool ok = true, in_comment = false;
    if (memchr(text.data, 0, text.size))
        ok = error_set(error, STATUS_SCENE, "%s:1: not a text file", file->path);
    for (char *line = text.data; ok && *line; number++) {
        char *end = line + strcspn(line, "\n");
        bool last = !*end;
        *end = 0;
        bool starts_in_comment = in_comment;
        in_comment = glsl_ends_in_comment(line, in_comment);
        if (!starts_in_comment) ok = read_line(file, line, number, error);
        line = last ? end : end + 1;
    }
    text_free(&text);
    for (int kind = 0; ok && kind < HINT_KINDS; kind++) ok = check_hints(file, (HintKind)kind, error);
    return ok && check_many_spheres(file, error) && try_presets(file, error);
}
