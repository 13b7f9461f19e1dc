#include "cmd/complete.h"

#include "choice/method.h"
#include "cmd/option_table.h"
#include "cmd/scene_find.h"
#include "cmd/setup.h"
#include "gl/context.h"
#include "scene/scene_list.h"
#include "scene/setting.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* An unfinished command line. */
typedef struct Unfinished {
    const CommandRow *command;
    /* The first word that is no option and no option's value; NULL where there is none yet. */
    const char *scene;
    int input_count;
    /* The option whose value the last word is, and the value as far as it is typed. Without an option, the
     * whole word. */
    const OptionRow *option;
    const char *value;
    /* What stands before the value in the last word: "--sky=", or "". */
    char front[64];
    /* Behind "--", all words are files. */
    bool only_inputs;
    Text *out;
} Unfinished;

/* Prints a word if the typed value is its start. */
static void offer(const Unfinished *line, const char *word, const char *meaning) {
    if (strncmp(word, line->value, strlen(line->value)) != 0) return;
    text_print(line->out, "%s%s", line->front, word);
    if (meaning && *meaning) text_print(line->out, "\t%.*s", (int)strcspn(meaning, "\n"), meaning);
    text_print(line->out, "\n");
}

static void offer_commands(const Unfinished *line) {
    for (int i = 0; i < command_table_size; i++) offer(line, command_table[i].name, command_table[i].about);
}

static void offer_options(const Unfinished *line) {
    for (int i = 0; i < option_table_size; i++) {
        const OptionRow *row = &option_table[i];
        if (!(row->commands & (int)line->command->command)) continue;
        offer(line, row->name, row->help);
        if (row->alias) offer(line, row->alias, row->help);
    }
}

/* Whether one of the words of a list, up to its last comma, is this one. */
static bool list_has(const char *list, int typed, const char *word, size_t length) {
    size_t there;
    for (const char *at = list; at < list + typed; at += there + 1) {
        there = strcspn(at, ",");
        if (there == length && strncmp(at, word, length) == 0) return true;
    }
    return false;
}

/* A list such as "albedo,depth": the typed words stay, and each of the others may follow. */
static void offer_words(const Unfinished *line) {
    const char *list = line->option->words, *comma = strrchr(line->value, ','), *word;
    int typed = line->option->kind == OPTION_STRING && comma ? (int)(comma + 1 - line->value) : 0;
    size_t length;
    while ((word = word_next(&list, &length))) {
        char whole[200];
        if (list_has(line->value, typed, word, length)) continue;
        snprintf(whole, sizeof whole, "%.*s%.*s", typed, line->value, (int)length, word);
        offer(line, whole, NULL);
    }
}

/* True if the option takes methods. */
static bool offer_methods(const Unfinished *line) {
    bool found = false;
    for (int i = 0; method_get(i); i++) {
        const Method *method = method_get(i);
        if (strcmp(method_family(method->family)->option, line->option->name) != 0) continue;
        if (!found) offer(line, "auto", method_family(method->family)->automatic);
        found = true;
        if (!method->variants[0]) offer(line, method->name, method->about);
        for (int v = 0; v < METHOD_MOST_VARIANTS && method->variants[v]; v++)
            offer(line, method->variants[v], method->about);
    }
    if (line->option->kind == OPTION_SWITCH) offer(line, "on", "the same as auto");
    if (line->command->command == COMMAND_SKY && strcmp(line->option->name, "--sky") == 0)
        offer(line, "reference", "with --at: double precision on the processor");
    return found;
}

/* The scene that is named, if it can be read. */
static bool read_scene(const Unfinished *line, Scene *scene) {
    Options none = {0};
    Error ignored;
    char *library = NULL, *path = NULL;
    bool ok = line->scene && setup_library(&none, &library, &ignored) &&
              scene_find(line->scene, library, &path, &ignored) && scene_read(scene, path, library, &ignored);
    free(path);
    free(library);
    return ok;
}

static void offer_presets(const Unfinished *line) {
    Scene scene;
    if (!read_scene(line, &scene)) return;
    for (int i = 0; i < scene.file->preset_count; i++) offer(line, scene.file->presets[i].name, NULL);
    scene_destroy(&scene);
}

static void offer_setting(const Unfinished *line, const char *name, const char *meaning) {
    char word[128];
    snprintf(word, sizeof word, "%s=", name);
    if (!strchr(line->value, '=')) offer(line, word, meaning);
}

static void offer_field(const Unfinished *line, const AtmosphereField *field) {
    offer_setting(line, field->setting, field->description);
    for (int i = 0; i < ATMOSPHERE_WORDS && field->words[i].word && strchr(line->value, '='); i++) {
        char word[128];
        snprintf(word, sizeof word, "%s=%s", field->setting, field->words[i].word);
        offer(line, word, NULL);
    }
}

static void offer_parameter(const Unfinished *line, const Parameter *parameter) {
    offer_setting(line, parameter->name, parameter->label);
    if (parameter->type != PARAMETER_CHECKBOX || !strchr(line->value, '=')) return;
    for (int on = 0; on < 2; on++) {
        char word[128];
        snprintf(word, sizeof word, "%s=%d", parameter->name, on);
        offer(line, word, on ? "on" : "off");
    }
}

static void offer_settings(const Unfinished *line) {
    Scene scene;
    if (read_scene(line, &scene)) {
        for (int i = 0; i < scene.file->parameter_count; i++)
            offer_parameter(line, &scene.file->parameters[i]);
        scene_destroy(&scene);
    }
    for (int i = 0; setting_common(i); i++) offer_setting(line, setting_common(i), NULL);
    for (int i = 0; atmosphere_field(i); i++) offer_field(line, atmosphere_field(i));
}

static void offer_atmospheres(const Unfinished *line) {
    for (int i = 0; atmosphere_preset(i); i++)
        offer(line, atmosphere_preset(i)->name, atmosphere_preset(i)->source);
}

static void offer_backends(const Unfinished *line) {
    offer(line, "auto", "the first that works");
    for (int i = 0; context_backend(i); i++) offer(line, context_backend(i)->name, NULL);
}

static void offer_value(const Unfinished *line) {
    static const struct {
        const char *name;
        void (*offer)(const Unfinished *line);
    } tables[] = {{"--preset", offer_presets},
                  {"--set", offer_settings},
                  {"--atmosphere", offer_atmospheres},
                  {"--backend", offer_backends}};
    const OptionRow *option = line->option;
    if (option->words) {
        offer_words(line);
        return;
    }
    if (offer_methods(line)) return;
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++) {
        if (strcmp(tables[i].name, option->name) != 0) continue;
        tables[i].offer(line);
        return;
    }
    if (strncmp(option->argument, "FILE", 4) == 0) text_print(line->out, ":files\n");
    if (strcmp(option->argument, "DIR") == 0) text_print(line->out, ":folders\n");
}

/* The scenes that are installed, and files. */
static void offer_inputs(const Unfinished *line) {
    Options none = {0};
    Error ignored;
    char *library;
    if (line->input_count >= line->command->max_inputs) return;
    if (line->command->command == COMMAND_HELP) {
        offer_commands(line);
        return;
    }
    if (line->command->command != COMMAND_COMPARE && setup_library(&none, &library, &ignored)) {
        char *folder = scene_list_folder(library);
        SceneList list = scene_list_read(folder);
        for (int i = 0; i < list.count; i++) offer(line, list.entries[i].name, list.entries[i].title);
        scene_list_free(&list);
        free(folder);
        free(library);
    }
    text_print(line->out, ":files\n");
}

static bool needs_value(const OptionRow *row) {
    return row && (row->kind == OPTION_TAKE || row->kind == OPTION_STRING || row->kind == OPTION_WORD);
}

/* Reads a finished word. Gives the option whose value the next word is, or may be. */
static const OptionRow *read_word(Unfinished *line, const char *word, const OptionRow *before) {
    if (needs_value(before)) return NULL;
    if (line->only_inputs || word[0] != '-' || !word[1]) {
        if (!line->input_count++) line->scene = word;
        return NULL;
    }
    line->only_inputs = strcmp(word, "--") == 0;
    return option_find(word, strlen(word), line->command->command);
}

/* The last word: an option's value behind "=" or behind the option, or the start of any other word. */
static void read_last(Unfinished *line, const char *word, const OptionRow *before) {
    const char *equals = strncmp(word, "--", 2) == 0 ? strchr(word, '=') : NULL;
    size_t length = equals ? (size_t)(equals - word) : 0;
    line->value = word;
    if (needs_value(before)) {
        line->option = before;
    } else if (equals && length < sizeof line->front - 1 && !line->only_inputs) {
        const OptionRow *row = option_find(word, length, line->command->command);
        if (!row || !row->argument) return;
        line->option = row;
        line->value = equals + 1;
        snprintf(line->front, sizeof line->front, "%.*s=", (int)length, word);
    }
}

void complete_print(int count, char *const *words, Text *out) {
    Unfinished line = {.out = out, .value = words[count - 1]};
    const OptionRow *before = NULL;
    if (count == 1) {
        offer_commands(&line);
        offer(&line, "--help", NULL);
        offer(&line, "--version", NULL);
        return;
    }
    bool help = strcmp(words[0], "--help") == 0 || strcmp(words[0], "-h") == 0;
    line.command = command_named(help ? "help" : words[0]);
    if (!line.command) return;
    for (int i = 1; i + 1 < count; i++) before = read_word(&line, words[i], before);
    read_last(&line, words[count - 1], before);
    if (line.option) {
        offer_value(&line);
    } else if (!line.only_inputs && line.value[0] == '-') {
        offer_options(&line);
    } else {
        if (before && before->kind == OPTION_SWITCH) {
            line.option = before;
            offer_methods(&line);
        }
        offer_inputs(&line);
    }
}
