#include "cmd/options_parse.h"

#include "base/near.h"
#include "base/text.h"
#include "choice/method.h"
#include "cmd/option_table.h"
#include "cmd/options_check.h"

#include <math.h>
#include <string.h>

static bool unknown_command(const char *word, Error *error) {
    Near near = near_to(word, strlen(word));
    for (int i = 0; i < command_table_size; i++) near_try(&near, command_table[i].name);
    return error_set(error, STATUS_USAGE, "unknown command '%s'%s%s%s (see magichour --help)", word,
                     near.name ? ": did you mean " : "", near.name ? near.name : "", near.name ? "?" : "");
}

/* An option of other commands: says which. */
static bool other_option(const char *word, size_t length, const CommandRow *command, Error *error) {
    Text commands = {0};
    for (int i = 0; i < command_table_size; i++) {
        if (!option_find(word, length, command_table[i].command)) continue;
        text_print(&commands, "%s%s", commands.size ? ", " : "", command_table[i].name);
    }
    bool found = commands.size > 0;
    if (found)
        error_set(error, STATUS_USAGE, "%s has no option '%.*s': it is one of %s (see magichour %s --help)",
                  command->name, (int)length, word, text_string(&commands), command->name);
    text_free(&commands);
    return found;
}

static bool unknown_option(const char *word, size_t length, const CommandRow *command, Error *error) {
    Near near = near_to(word, length);
    for (int i = 0; i < option_table_size; i++) {
        if (!(option_table[i].commands & (int)command->command)) continue;
        near_try(&near, option_table[i].name);
        if (option_table[i].alias) near_try(&near, option_table[i].alias);
    }
    if (other_option(word, length, command, error)) return false;
    return error_set(error, STATUS_USAGE, "unknown option '%.*s'%s%s%s (see magichour %s --help)",
                     (int)length, word, near.name ? ": did you mean " : "", near.name ? near.name : "",
                     near.name ? "?" : "", command->name);
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
    case OPTION_WORD:
        return take_word(option->words, option->name, value, (const char **)target, error);
    case OPTION_OPTIONAL:
    case OPTION_SWITCH:
        *(const char **)target = value ? value : "auto";
        return true;
    case OPTION_TAKE:
        return option->take(options, option->name, value, error);
    }
    return false;
}

/* Whether a word that stands behind the option is the option's, although no "=" binds it. */
static bool is_switch_word(const OptionRow *option, const char *word) {
    if (option->kind != OPTION_SWITCH || !word) return false;
    if (strcmp(word, "on") == 0) return true;
    for (int i = 0; method_get(i); i++) {
        const Method *method = method_get(i);
        if (strcmp(method_family(method->family)->option, option->name) == 0 &&
            strcmp(method->name, word) == 0)
            return true;
    }
    return false;
}

/* One option's word, cut into its name and the value that is bound to it: --sky=gauss, -oFILE, -o=FILE. */
typedef struct OptionWord {
    const char *name;
    size_t length;
    const char *value;
} OptionWord;

static OptionWord cut_word(const char *word, Command command) {
    if (option_find(word, strlen(word), command)) return (OptionWord){word, strlen(word), NULL};
    bool two_dashes = word[1] == '-';
    const char *equals = two_dashes ? strchr(word, '=') : NULL;
    size_t length = two_dashes ? (equals ? (size_t)(equals - word) : strlen(word)) : 2;
    const char *value = equals ? equals + 1 : !two_dashes && word[2] ? word + 2 + (word[2] == '=') : NULL;
    return (OptionWord){word, length, value};
}

/* The value of an option that needs one: what is bound to it, or the next word, unless that is an option. */
static bool find_value(OptionWord *word, const OptionRow *option, int argc, char **argv, int *at,
                       const CommandRow *command, Error *error) {
    if (word->value) return true;
    const char *next = *at + 1 < argc ? argv[*at + 1] : NULL;
    OptionWord cut = next && next[0] == '-' && next[1] ? cut_word(next, command->command) : (OptionWord){0};
    if (next && !(cut.length == strlen(next) && option_find(next, cut.length, command->command))) {
        word->value = argv[++*at];
        return true;
    }
    return error_set(error, STATUS_USAGE, "%s needs a value %s%s%s%s", option->name, option->argument,
                     next ? ", and '" : "", next ? next : "", next ? "' is an option" : "");
}

/* Reads the option argv[*at] and moves *at past its value. */
static bool parse_option(Options *options, int argc, char **argv, int *at, const CommandRow *command,
                         Error *error) {
    OptionWord word = cut_word(argv[*at], command->command);
    const OptionRow *option = option_find(word.name, word.length, command->command);
    /* A long option with one dash is more likely than a short one with a value. */
    if (!option || (option->kind == OPTION_FLAG && word.value && word.name[1] != '-'))
        return unknown_option(word.name, word.name[1] == '-' ? word.length : strlen(word.name), command,
                              error);
    switch (option->kind) {
    case OPTION_FLAG:
        if (word.value) return error_set(error, STATUS_USAGE, "%s takes no value", option->name);
        break;
    case OPTION_OPTIONAL:
        break;
    case OPTION_SWITCH:
        if (!word.value && *at + 1 < argc && is_switch_word(option, argv[*at + 1])) word.value = argv[++*at];
        if (word.value && strcmp(word.value, "on") == 0) word.value = "auto";
        break;
    case OPTION_STRING:
    case OPTION_WORD:
    case OPTION_TAKE:
        if (!find_value(&word, option, argc, argv, at, command, error)) return false;
    }
    return take_option(options, option, word.value, error);
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
    const CommandRow *asked = options->input_count ? command_named(options->inputs[0]) : NULL;
    if (options->input_count && !asked) return unknown_command(options->inputs[0], error);
    if (!options->help) options->command = asked ? asked->command : COMMAND_NONE;
    options->help = !options->version;
    return true;
}

bool options_parse(Options *options, int argc, char **argv, Error *error) {
    *options =
        (Options){.max_relrmse_percent = INFINITY, .max_bias_percent = INFINITY, .max_levels = INFINITY};
    if (argc < 2) return error_set(error, STATUS_USAGE, "which command? (see magichour --help)");
    options->version = strcmp(argv[1], "--version") == 0;
    if (options->version) return true;
    /* `--help render` is `help render`. */
    bool help = strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0;
    const CommandRow *command = command_named(help ? "help" : argv[1]);
    if (!command) return unknown_command(argv[1], error);
    options->command = command->command;
    if (!parse_words(options, argc, argv, command, error)) return false;
    if (command->command == COMMAND_VERSION) options->version = !options->help;
    if (command->command == COMMAND_HELP) return take_help(options, error);
    return options->help || options->version || options_check(options, error);
}
