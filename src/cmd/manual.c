#include "cmd/manual.h"

#include "base/version.h"
#include "cmd/help_words.h"

#include <string.h>

enum { COLUMNS = 76 };

/* Prints words for man(7), in lines of the source that are not too long to be read: hyphens are escaped, and
 * no line starts with a macro. */
static void print_words(const char *words, Text *out) {
    int column = 0;
    for (const char *c = words; *c; c++, column++) {
        if (*c == ' ' && column + (int)strcspn(c + 1, " ") >= COLUMNS) {
            text_print(out, "\n");
            column = -1;
            if (c[1] == '.' || c[1] == '\'') text_print(out, "\\&");
        } else if (*c == '-')
            text_print(out, "\\-");
        else if (*c == '\\')
            text_print(out, "\\e");
        else if ((*c == '.' || *c == '\'') && (c == words || c[-1] == '\n'))
            text_print(out, "\\&%c", *c);
        else
            text_append(out, c, 1);
    }
}

/* Words that stay on one line, as the macro in front of them needs. */
static void print_term(const char *words, Text *out) {
    for (const char *c = words; *c; c++) text_print(out, *c == '-' ? "\\-" : "%c", *c);
}

/* A term of the page and what it means. */
typedef struct Entry {
    const char *term, *text;
} Entry;

static const Entry environment[] = {
    {"DISPLAY, WAYLAND_DISPLAY", "where view opens its window, and one of the ways to OpenGL for the others"},
    {"MAGICHOUR_OSMESA", "the file of the library OSMesa, in place of the one that the system finds"},
};

static const Entry files[] = {
    {"PREFIX/share/magichour/scenes",
     "scenes that are found by their names; README.md describes how to write one"},
    {"PREFIX/share/magichour/glsl",
     "the GLSL library, which is looked for on the way up from the program; --glsl-dir "
     "names another"},
    {"PREFIX/share/doc/magichour", "README.md, CHANGES.md and the licence"},
};

static const Entry examples[] = {
    {"magichour info", "what scenes, methods and atmospheres there are"},
    {"magichour view crater", "a window with an installed scene"},
    {"magichour render crater -o a.png --sun 5,90 --error 2levels",
     "the sun 5 degrees high, toward +x, until the error is 2 levels of 255"},
    {"magichour render my.glsl -o - --format png --set height=2 > a.png",
     "a scene of one's own, with a parameter, to standard output"},
    {"magichour sky -o sky.exr --sun 10 --sun-disk", "a map of the sky"},
    {"magichour compare a.exr reference.exr --max-relrmse 1",
     "exit status 6 if the error is larger than 1 %"},
};

static void print_section(const char *name, const Entry *entries, size_t count, Text *out) {
    text_print(out, ".SH %s\n", name);
    for (size_t i = 0; i < count; i++) {
        text_print(out, ".TP\n.B ");
        print_term(entries[i].term, out);
        text_print(out, "\n");
        print_words(entries[i].text, out);
        text_print(out, "\n");
    }
}

static void print_option(const OptionRow *row, Text *out) {
    char words[40];
    help_option_words(row, words, sizeof words);
    text_print(out, ".TP\n.B ");
    print_term(words, out);
    text_print(out, "\n");
    Text help = {0};
    help_option_text(row, &help);
    print_words(text_string(&help), out);
    text_free(&help);
    text_print(out, "\n(");
    bool first = true;
    for (int i = 0; i < command_table_size; i++) {
        if (!(row->commands & (int)command_table[i].command)) continue;
        text_print(out, "%s%s", first ? "" : ", ", command_table[i].name);
        first = false;
    }
    text_print(out, ")\n");
}

void manual_print(Text *out) {
    text_print(out, ".TH MAGICHOUR 1 \"\" \"magichour " MAGICHOUR_VERSION "\"\n.SH NAME\nmagichour \\- ");
    print_words(help_about, out);
    text_print(out, "\n.SH SYNOPSIS\n.B magichour\n.I COMMAND\n[options]\n.SH COMMANDS\n");
    for (int i = 0; i < command_table_size; i++) {
        text_print(out, ".TP\n.B magichour ");
        print_term(command_table[i].usage, out);
        text_print(out, "\n");
        print_words(command_table[i].about, out);
        text_print(out, "\n");
    }
    text_print(out, ".SH OPTIONS\nThe commands that take an option stand below it, in parentheses.\n");
    for (int group = 0; group < OPTION_GROUPS; group++) {
        text_print(out, ".SS %s\n", option_group_names[group]);
        for (int i = 0; i < option_table_size; i++) {
            if (option_table[i].group == (OptionGroup)group) print_option(&option_table[i], out);
        }
    }
    text_print(out, ".SH EXIT STATUS\n");
    for (int i = 0; help_status(i); i++)
        text_print(out, ".TP\n.B %d\n%s\n", help_status(i)->status, help_status(i)->meaning);
    print_section("ENVIRONMENT", environment, sizeof environment / sizeof *environment, out);
    print_section("FILES", files, sizeof files / sizeof *files, out);
    print_section("EXAMPLES", examples, sizeof examples / sizeof *examples, out);
}
