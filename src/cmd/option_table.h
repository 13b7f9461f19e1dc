/* The one table of commands and options, from which parsing, help and the manual page are made. */
#pragma once

#include "cmd/option_values.h"

typedef struct CommandRow {
    Command command;
    const char *name, *usage, *about;
    int min_inputs, max_inputs;
} CommandRow;

/* The headings under which help lists options. */
typedef enum OptionGroup {
    GROUP_OUTPUT,
    GROUP_SKY,
    GROUP_ACCURACY,
    GROUP_METHODS,
    GROUP_OTHER,
    OPTION_GROUPS
} OptionGroup;

/* Options that only keep their word or switch something on need no code of their own. */
typedef enum OptionKind {
    /* Its value goes through `take`. */
    OPTION_TAKE,
    /* Its value is kept as it is. */
    OPTION_STRING,
    /* Its value is one of `words`. */
    OPTION_WORD,
    /* It has no value. */
    OPTION_FLAG,
    /* It keeps the word after its "=", or "auto" where there is none. */
    OPTION_OPTIONAL,
    /* The same, and the next word is its word if that is `on`, `off` or a method. `on` stands for "auto". */
    OPTION_SWITCH
} OptionKind;

typedef struct OptionRow {
    OptionGroup group;
    const char *name;
    /* What stands for its value in help; NULL for a flag. */
    const char *argument;
    /* The commands to which it belongs, as a set of bits. An option may have further rows for other
     * commands. */
    int commands;
    OptionKind kind;
    OptionTake *take;
    /* The offset of its string or flag in Options. */
    size_t offset;
    /* The words that its value may be, or may be a list of, with commas between them; NULL where there are
     * none, or where they are in another table. */
    const char *words;
    /* What it does. For an option that takes a method, help adds the methods (choice/method.h). */
    const char *help;
    /* A second name, or NULL. */
    const char *alias;
} OptionRow;

extern const CommandRow command_table[];
extern const int command_table_size;

extern const OptionRow option_table[];
extern const int option_table_size;

extern const char *const option_group_names[OPTION_GROUPS];

/* The row of an option of the command, by its name or its second name; NULL if there is none. */
const OptionRow *option_find(const char *word, size_t length, Command command);

/* The command of that name; NULL if there is none. */
const CommandRow *command_named(const char *word);

/* The command's row; NULL for COMMAND_NONE. */
const CommandRow *command_find(Command command);
