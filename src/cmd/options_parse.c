#include "cmd/options_parse.h"

#include "base/near.h"
#include "cmd/option_table.h"

#include <math.h>
#include <string.h>

static bool is_name(const char *name, const char *word, size_t length) {
    return name && strlen(name) == length && strncmp(name, word, length) == 0;
}

static const OptionRow *find_option(const char *word, size_t length, Command command) {
    for (int i = 0; i < option_table_size; i++) {
        const OptionRow *row = &option_table[i];
        if (!(row->commands & (int)command)) continue;
        if (is_name(row->name, word, length) || is_name(row->alias, word, length)) return row;
    }
    return NULL;
}

static const CommandRow *find_command(const char *word) {
    for (int i = 0; i < command_table_size; i++) {
        if (strcmp(command_table[i].name, word) == 0) return &command_table[i];
    }
    return NULL;
}

static const char *nearest_option(const char *word, size_t length, Command command) {
    Near near = near_to(word, length);
    for (int i = 0; i < option_table_size; i++) {
        if (option_table[i].commands & (int)command) near_try(&near, option_table[i].name);
    }
    return near.name;
}

static bool unknown_command(const char *word, Error *error) {
    Near near = near_to(word, strlen(word));
    for (int i = 0; i < command_table_size; i++) near_try(&near, command_table[i].name);
    return error_set(error, STATUS_USAGE, "unknown command '%s'%s%s%s (see magichour --help)", word,
                     near.name ? ": did you mean " : "", near.name ? near.name : "", near.name ? "?" : "");
}

static bool unknown_option(const char *word, size_t length, const CommandRow *command, Error *error) {
    const char *nearest = nearest_option(word, length, command->command);
    return error_set(error, STATUS_USAGE, "unknown option '%.*s'%s%s%s (see magichour %s --help)",
                     (int)length, word, nearest ? ": did you mean " : "", nearest ? nearest : "",
                     nearest ? "?" : "", command->name);
}

static bool take_option(Options *options, const OptionRow *option, const char *value, Error *error) {
    void *target = (char *)options + option->offset;
    switch (option->kind) {
    case OPTION_FLAG:
        *(bool *)target = true;
        return true;
    case OPTION_STRING:
        *(const char **)target = value;
        return true;
    case OPTION_OPTIONAL:
        *(const char **)target = value ? value : "auto";
        return true;
    case OPTION_TAKE:
        return option->take(options, option->name, value, error);
    }
    return false;
}

/* Reads the option argv[*at] and moves *at past its value. */
static bool parse_option(Options *options, int argc, char **argv, int *at, const CommandRow *command,
                         Error *error) {
    const char *word = argv[*at];
    const char *equals = strncmp(word, "--", 2) == 0 ? strchr(word, '=') : NULL;
    size_t length = equals ? (size_t)(equals - word) : strlen(word);
    const OptionRow *option = find_option(word, length, command->command);
    if (!option) return unknown_option(word, length, command, error);
    const char *value = equals ? equals + 1 : NULL;
    if (option->kind == OPTION_FLAG && value)
        return error_set(error, STATUS_USAGE, "%s takes no value", option->name);
    if (option->kind != OPTION_FLAG && option->kind != OPTION_OPTIONAL && !value) {
        if (*at + 1 >= argc)
            return error_set(error, STATUS_USAGE, "%s needs a value %s", option->name, option->argument);
        value = argv[++*at];
    }
    return take_option(options, option, value, error);
}

static bool parse_words(Options *options, int argc, char **argv, const CommandRow *command, Error *error) {
    bool only_inputs = false;
    for (int i = 2; i < argc && !options->help && !options->version; i++) {
        if (!only_inputs && strcmp(argv[i], "--") == 0) {
            only_inputs = true;
        } else if (!only_inputs && argv[i][0] == '-' && argv[i][1]) {
            if (!parse_option(options, argc, argv, &i, command, error)) return false;
        } else if (options->input_count == command->max_inputs) {
            return error_set(error, STATUS_USAGE, "'%s' is one file too many (usage: magichour %s)", argv[i],
                             command->usage);
        } else {
            options->inputs[options->input_count++] = argv[i];
        }
    }
    if (!options->help && !options->version && options->input_count < command->min_inputs)
        return error_set(error, STATUS_USAGE, "usage: magichour %s", command->usage);
    return true;
}

/* `help render` means `render --help`, and `help` alone means `--help`. */
static bool take_help(Options *options, Error *error) {
    const CommandRow *asked = options->input_count ? find_command(options->inputs[0]) : NULL;
    if (options->input_count && !asked) return unknown_command(options->inputs[0], error);
    if (!options->help) options->command = asked ? asked->command : COMMAND_NONE;
    options->help = !options->version;
    return true;
}

bool options_parse(Options *options, int argc, char **argv, Error *error) {
    *options =
        (Options){.max_relrmse_percent = INFINITY, .max_bias_percent = INFINITY, .max_levels = INFINITY};
    if (argc < 2) return error_set(error, STATUS_USAGE, "which command? (see magichour --help)");
    options->help = strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0;
    options->version = strcmp(argv[1], "--version") == 0;
    if (options->help || options->version) return true;
    const CommandRow *command = find_command(argv[1]);
    if (!command) return unknown_command(argv[1], error);
    options->command = command->command;
    if (!parse_words(options, argc, argv, command, error)) return false;
    return command->command != COMMAND_HELP || take_help(options, error);
}
