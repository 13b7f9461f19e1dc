#include "cmd/help.h"
#include "cmd/help_words.h"

#include "choice/method.h"
#include "cmd/option_table.h"

#include <stdio.h>
#include <string.h>

const char help_about[] = "a progressive renderer for small scenes under a physical sky";

static const HelpStatus statuses[] = {
    {STATUS_DONE, "done"},
    {STATUS_FAILURE, "failure while running"},
    {STATUS_USAGE, "wrong command line"},
    {STATUS_SCENE, "wrong scene or shader"},
    {STATUS_NO_GL, "no OpenGL"},
    {STATUS_OUTPUT, "output not written"},
    {STATUS_COMPARISON, "comparison past its bound"},
    {STATUS_UNPROMISED, "the picture is saved, but the error that --error asked for is not promised"},
    {STATUS_INTERRUPTED, "interrupted, with the picture saved"},
};
enum { STATUSES = sizeof statuses / sizeof *statuses };

const HelpStatus *help_status(int index) {
    return index >= 0 && index < STATUSES ? &statuses[index] : NULL;
}

/* Prints words in lines that end before column `columns`. The first word is at column `column`, and further
 * lines begin at column `indent`. */
static void print_wrapped(const char *words, int column, int indent, int columns, Text *out) {
    bool first = true;
    while (*words) {
        int length = (int)strcspn(words, " ");
        if (!first && column + 1 + length > columns) {
            text_print(out, "\n%*s", indent, "");
            column = indent;
        } else if (!first) {
            text_print(out, " ");
            column++;
        }
        text_print(out, "%.*s", length, words);
        column += length;
        words += length;
        words += strspn(words, " ");
        first = false;
    }
    text_print(out, "\n");
}

/* Prints a row of two columns. A left side that does not fit has a line of its own. */
static void print_row(const char *left, int indent, const char *right, int columns, Text *out) {
    if ((int)strlen(left) > indent - 4)
        text_print(out, "  %s\n%*s", left, indent, "");
    else
        text_print(out, "  %-*s", indent - 2, left);
    print_wrapped(right, indent, indent, columns, out);
}

void help_option_words(const OptionRow *row, char *words, size_t size) {
    snprintf(words, size, "%s%s%s%s%s", row->alias ? row->alias : "", row->alias ? ", " : "", row->name,
             row->argument && row->argument[0] != '[' ? " " : "", row->argument ? row->argument : "");
}

void help_option_text(const OptionRow *row, Text *out) {
    text_print(out, "%s", row->help);
    for (int family = 0; family < METHOD_FAMILIES; family++) {
        const MethodFamilyRow *methods = method_family((MethodFamily)family);
        if (strcmp(methods->option, row->name) != 0) continue;
        const char *separator = ": ";
        for (int i = 0; method_get(i); i++) {
            const Method *method = method_get(i);
            if ((int)method->family != family) continue;
            text_print(out, "%s%s", separator, method->form ? method->form : method->name);
            separator = ", ";
        }
        text_print(out, "; auto is %s", methods->automatic);
    }
}

static void print_program(int columns, Text *out) {
    text_print(out, "magichour: ");
    print_wrapped(help_about, 11, 0, columns, out);
    text_print(out, "\nmagichour COMMAND [options]\n");
    for (int i = 0; i < command_table_size; i++)
        print_row(command_table[i].name, 12, command_table[i].about, columns, out);
    text_print(out, "\n");
    print_wrapped("magichour help COMMAND lists a command's options. magichour --version tells the version.",
                  0, 0, columns, out);
    text_print(out, "\nExit status:\n");
    for (int i = 0; i < STATUSES; i++) text_print(out, "  %-4d%s\n", statuses[i].status, statuses[i].meaning);
}

static void print_group(Command command, OptionGroup group, int columns, Text *out) {
    bool named = false;
    for (int i = 0; i < option_table_size; i++) {
        const OptionRow *row = &option_table[i];
        char left[40];
        if (row->group != group || !(row->commands & (int)command)) continue;
        if (!named) text_print(out, "\n%s\n", option_group_names[group]);
        named = true;
        help_option_words(row, left, sizeof left);
        Text help = {0};
        help_option_text(row, &help);
        print_row(left, columns < 72 ? 8 : 26, text_string(&help), columns, out);
        text_free(&help);
    }
}

void help_print(Command command, int columns, Text *out) {
    if (columns < 48) columns = 48;
    const CommandRow *row = command_find(command);
    if (!row) {
        print_program(columns, out);
        return;
    }
    text_print(out, "magichour %s\n", row->usage);
    print_wrapped(row->about, 0, 0, columns, out);
    for (int group = 0; group < OPTION_GROUPS; group++)
        print_group(command, (OptionGroup)group, columns, out);
}
