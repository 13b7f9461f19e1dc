#include "scene/annotation.h"

#include "base/known.h"
#include "base/lines.h"
#include "scene/annotation_air.h"
#include "scene/annotation_hints.h"
#include "scene/annotation_mist.h"
#include "scene/annotation_parameters.h"
#include "scene/setting.h"
#include "source/glsl_blocks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool read_title(Line *line, Error *error) {
    (void)error;
    free(line->file->title);
    line->file->title = line_join(line, 1);
    return true;
}

static bool read_look(Line *line, Error *error) {
    (void)error;
    free(line->file->look);
    line->file->look = line_join(line, 1);
    return true;
}

/* Keys with numbers behind them, in any order, as in `camera eye 0 2 -4 fov 90`: each is a setting. */
typedef struct Key {
    const char *name, *setting;
    int count;
} Key;

static bool unknown_key(const Line *line, int at, const Key *table, int entries, Error *error) {
    Known known = known_to(line->words[at], strlen(line->words[at]));
    for (int i = 0; i < entries; i++) known_add(&known, table[i].name);
    return known_fail(&known, STATUS_SCENE, error, "%s: unknown key '%s'", line->words[0], line->words[at]);
}

/* Keys may stand in several lines, but each of them once. */
static bool key_once(Line *line, const Key *key, Error *error) {
    char name[64];
    snprintf(name, sizeof name, "%s %s", line->words[0], key->name);
    return line_once(line, name, error);
}

static bool read_keys(Line *line, const Key *table, int entries, Error *error) {
    for (int at = 1; at < line->count;) {
        const Key *key = NULL;
        for (int i = 0; i < entries; i++) {
            if (strcmp(table[i].name, line->words[at]) == 0) key = &table[i];
        }
        if (!key) return unknown_key(line, at, table, entries, error);
        if (!key_once(line, key, error) || !line_setting(line, at + 1, key->count, key->setting, error))
            return false;
        at += 1 + key->count;
    }
    if (line->count > 1) return true;
    return error_set(error, STATUS_SCENE, "%s needs %s and its value", line->words[0], table[0].name);
}

static bool read_camera(Line *line, Error *error) {
    static const Key table[] = {
        {"eye", "camera.eye", 3}, {"target", "camera.target", 3}, {"fov", "camera.fov", 1}};
    return read_keys(line, table, 3, error);
}

static bool read_sun(Line *line, Error *error) {
    static const Key table[] = {{"elevation", "sun.elevation", 1}, {"azimuth", "sun.azimuth", 1},
                                {"radius", "sun.radius", 1},       {"when", "sun.when", 1},
                                {"where", "sun.where", 1},         {"north", "sun.north", 1}};
    if (!read_keys(line, table, 6, error)) return false;
    if (!line_has(line, "sun when") || (!line_has(line, "sun elevation") && !line_has(line, "sun azimuth")))
        return true;
    return error_set(error, STATUS_SCENE,
                     "sun: elevation and azimuth say where the sun stands, and so does when: one of them");
}

static bool read_exposure(Line *line, Error *error) {
    return line_setting(line, 1, 1, "exposure", error) && line_end(line, 2, error);
}

static bool read_sun_disk(Line *line, Error *error) {
    bool on = line->count == 2 && strcmp(line->words[1], "on") == 0;
    if (!on && (line->count != 2 || strcmp(line->words[1], "off") != 0))
        return error_set(error, STATUS_SCENE, "sun-disk needs on or off");
    line->file->sun_disk_line = line->number;
    line->file->values.sun_disk = on;
    return true;
}

static bool read_size(Line *line, Error *error) {
    double size[2];
    if (!line_numbers(line, 1, 2, 0, 1e9, size, error) || !line_end(line, 3, error) ||
        !scene_check_size(size[0], size[1], error))
        return false;
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
    return line_copy_word(line->file->sky, sizeof line->file->sky, line->words[1], error);
}

static bool read_atmosphere(Line *line, Error *error) {
    if (line->count != 2) return error_set(error, STATUS_SCENE, "atmosphere needs a preset's name");
    line->file->atmosphere_line = line->number;
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
    if (!line_copy_word(preset->name, sizeof preset->name, line->words[1], error)) return false;
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
        for (int k = 2; k < i; k += 2) {
            if (strcmp(line->words[k], line->words[i]) == 0)
                return error_set(error, STATUS_SCENE, "preset %s sets %s twice", preset->name,
                                 line->words[i]);
        }
        if (!line_copy_word(setting->name, sizeof setting->name, line->words[i], error) ||
            !line_copy_word(setting->value, sizeof setting->value, line->words[i + 1], error)) {
            return false;
        }
    }
    return true;
}

static const struct {
    const char *key;
    bool (*read)(Line *line, Error *error);
    /* Whether a second one would only undo the first. */
    bool once;
} annotations[] = {
    {"title", read_title, true},
    {"look", read_look, true},
    {"camera", read_camera, false},
    {"sun", read_sun, false},
    {"size", read_size, true},
    {"exposure", read_exposure, true},
    {"sky", read_sky, true},
    {"atmosphere", read_atmosphere, true},
    {"preset", read_preset, false},
    {"sun-disk", read_sun_disk, true},
    {"slider", parameters_read_slider, false},
    {"checkbox", parameters_read_checkbox, false},
    {"color", parameters_read_color, false},
    {"spheres", hints_read_spheres, true},
    {"mist", mist_read, false},
    {"air", air_read, true},
};
enum { ANNOTATIONS = sizeof annotations / sizeof *annotations };

static bool read_annotation(Line *line, Error *error) {
    HintKind kind;
    if (!line->count) return error_set(error, STATUS_SCENE, "an annotation needs a key");
    if (hints_know(line, &kind)) return hints_read(line, kind, error);
    for (int i = 0; i < ANNOTATIONS; i++) {
        if (strcmp(annotations[i].key, line->words[0]) != 0) continue;
        return (!annotations[i].once || line_once(line, annotations[i].key, error)) &&
               annotations[i].read(line, error);
    }
    Known known = known_to(line->words[0], strlen(line->words[0]));
    for (int i = 0; i < ANNOTATIONS; i++) known_add(&known, annotations[i].key);
    for (int i = 0; i < HINT_KINDS; i++) known_add(&known, hint_info((HintKind)i)->key);
    return known_fail(&known, STATUS_SCENE, error, "unknown annotation '%s'", line->words[0]);
}

static bool read_line(SceneFile *file, LineSeen *seen, char *text, int number, Error *error) {
    char *mark = strstr(text, "//@");
    char *comment = strstr(text, "//");
    if (!mark || comment != mark) return true;
    *mark = 0;
    Line line = {.file = file, .seen = seen, .declaration = text, .number = number};
    if (line_cut(&line, mark + 3, error) && read_annotation(&line, error)) return true;
    error->status = STATUS_SCENE;
    return error_prefix(error, "%s:%d: ", file->path, number);
}

/* A preset's settings may name parameters declared below it, so all are tried at the end, on a copy. */
static bool try_presets(const SceneFile *file, Error *error) {
    for (int i = 0; i < file->preset_count; i++) {
        SceneValues trial = file->values;
        if (setting_choose_preset(file, &trial, file->presets[i].name, error)) continue;
        error->status = STATUS_SCENE;
        return error_prefix(error, "%s:%d: ", file->path, file->presets[i].line);
    }
    return true;
}

bool annotation_read(SceneFile *file, Error *error) {
    const SourceFile *read;
    if (!source_store_read(file->sources, file->path, &read, error)) return false;
    GlslBlocks blocks = {0};
    LineSeen seen = {0};
    Lines lines = lines_of(text_string(&read->text));
    bool ok = true;
    for (char *line; ok && (line = lines_next(&lines));) {
        if (glsl_line_counts(&blocks, line)) ok = read_line(file, &seen, line, lines.number, error);
    }
    lines_free(&lines);
    line_seen_free(&seen);
    return ok && hints_check(file, error) && mist_check(file, error) && try_presets(file, error);
}
