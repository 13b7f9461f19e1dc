/* The command line, and the help and the manual page that its table makes. */
#include "support.h"

#include "cmd/help.h"
#include "cmd/manual.h"
#include "cmd/option_table.h"
#include "cmd/options_parse.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Parses a command line of words between blanks. */
static bool parse(Options *options, const char *line, Error *error) {
    static char words[512];
    char *argv[32] = {0};
    int argc = 0;
    strcpy(words, line);
    for (char *word = strtok(words, " "); word; word = strtok(NULL, " ")) argv[argc++] = word;
    return options_parse(options, argc, argv, error);
}

static void test_options(void **state) {
    (void)state;
    Options options;
    Error error;
    assert_true(parse(&options,
                      "magichour render a.glsl -o a.exr -o b.png --size 320x200 --sun -2.5,90 --set ball=0 "
                      "--sky=paper:64x16 --spp 9 --seed 7 --depth 8 --exposure -1 --quiet",
                      &error));
    assert_int_equal(options.command, COMMAND_RENDER);
    assert_string_equal(options.inputs[0], "a.glsl");
    assert_int_equal(options.output_count, 2);
    assert_int_equal(options.width, 320);
    assert_int_equal(options.height, 200);
    assert_true(options.has_sun && options.sun_elevation_deg == -2.5);
    assert_true(options.has_azimuth && options.sun_azimuth_deg == 90);
    assert_string_equal(options.settings[0], "ball=0");
    assert_string_equal(options.sky, "paper:64x16");
    assert_int_equal(options.samples, 9);
    assert_int_equal(options.seed, 7);
    assert_int_equal(options.depth, 8);
    assert_true(options.has_exposure && options.exposure_ev == -1);
    assert_true(options.quiet && isinf(options.max_bias_percent));
    assert_true(parse(&options, "magichour render -o a.exr -- -odd.glsl", &error));
    assert_string_equal(options.inputs[0], "-odd.glsl");
    assert_true(parse(&options, "magichour render a.glsl --sun 12", &error));
    assert_false(options.has_azimuth);
}

/* Every option takes its value in each of the usual ways: behind a blank and behind "="; one with a short
 * name also right behind that. */
static void test_option_forms(void **state) {
    (void)state;
    static const char *const outputs[] = {"-o a.exr",       "-oa.exr",        "-o=a.exr",
                                          "--output a.exr", "--output=a.exr", "-o -"};
    Options options;
    Error error = {0};
    char line[256];
    for (size_t i = 0; i < sizeof outputs / sizeof *outputs; i++) {
        snprintf(line, sizeof line, "magichour render a %s --spp=3", outputs[i]);
        if (!parse(&options, line, &error)) fail_msg("%s: %s", line, error.text);
        assert_string_equal(options.outputs[0], i < 5 ? "a.exr" : "-");
        assert_true(options.output_count == 1 && options.samples == 3 && options.input_count == 1);
    }
    for (int i = 0; i < option_table_size; i++) {
        const OptionRow *row = &option_table[i];
        if (row->kind != OPTION_STRING || row->name[1] != '-') continue;
        for (int c = 0; c < command_table_size; c++) {
            if (!(row->commands & (int)command_table[c].command)) continue;
            const char *files = command_table[c].min_inputs == 2 ? "a b"
                                : command_table[c].min_inputs    ? "a"
                                                                 : "";
            for (int bound = 0; bound < 2; bound++) {
                snprintf(line, sizeof line, "magichour %s %s %s%cword", command_table[c].name, files,
                         row->name, bound ? '=' : ' ');
                if (!parse(&options, line, &error)) fail_msg("%s: %s", line, error.text);
                assert_string_equal(*(const char **)(void *)((char *)&options + row->offset), "word");
            }
        }
    }
}

/* The sun's disk as scenes write it, with the word behind a blank or not. The scene's file may stand behind
 * the option that has no word. */
static void test_sun_disk_forms(void **state) {
    (void)state;
    static const struct {
        const char *words, *method;
    } cases[] = {
        {"--sun-disk", "auto"},          {"--sun-disk on", "auto"},   {"--sun-disk=on", "auto"},
        {"--sun-disk off", "off"},       {"--sun-disk=off", "off"},   {"--sun-disk chance", "chance"},
        {"--sun-disk=chance", "chance"}, {"--sun-disk=auto", "auto"}, {"--quiet", NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        for (int first = 0; first < 2; first++) {
            Options options;
            Error error = {0};
            char line[256];
            snprintf(line, sizeof line, "magichour render %s %s %s", first ? "" : "a.glsl", cases[i].words,
                     first ? "a.glsl" : "");
            if (!parse(&options, line, &error)) fail_msg("%s: %s", line, error.text);
            assert_string_equal(options.inputs[0], "a.glsl");
            assert_true(!cases[i].method == !options.sun_disk);
            if (cases[i].method) assert_string_equal(options.sun_disk, cases[i].method);
        }
    }
}

static void test_options_refused(void **state) {
    (void)state;
    static const struct {
        const char *line, *part;
    } cases[] = {
        {"magichour", "which command"},
        {"magichour paint", "unknown command 'paint' (see"},
        {"magichour rendr a", "unknown command 'rendr': did you mean render?"},
        {"magichour help paint", "unknown command 'paint'"},
        {"magichour help render view", "'view' is one file too many"},
        {"magichour render", "usage: magichour render SCENE"},
        {"magichour render a b", "'b' is one file too many"},
        {"magichour render a --frob", "unknown option '--frob' (see"},
        {"magichour render a --sundisk", "unknown option '--sundisk': did you mean --sun-disk?"},
        {"magichour render a --psp=4", "unknown option '--psp': did you mean --spp?"},
        {"magichour render a --exposure-value 1", "unknown option '--exposure-value' (see"},
        {"magichour render a -x", "unknown option '-x' (see"},
        {"magichour compare a b --spp 3", "compare has no option '--spp': it is one of render, view (see"},
        {"magichour sky -o a.exr --light=mis",
         "sky has no option '--light': it is one of render, view, flatten"},
        {"magichour render a -sun 3", "unknown option '-sun': did you mean --sun?"},
        {"magichour render a --outptu b", "unknown option '--outptu': did you mean --output?"},
        {"magichour render a -o --quiet", "-o needs a value FILE, and '--quiet' is an option"},
        {"magichour render a --sky --light mis", "--sky needs a value METHOD, and '--light' is an option"},
        {"magichour render a -o", "-o needs a value FILE"},
        {"magichour render a --output=", "-o: an empty word names no file"},
        {"magichour render a -vquiet", "unknown option '-vquiet'"},
        {"magichour render a --sun-disk never", "'never' is one file too many"},
        {"magichour version a", "'a' is one file too many"},
        {"magichour verison", "unknown command 'verison': did you mean version?"},
        {"magichour --help rendre", "unknown command 'rendre': did you mean render?"},
        {"magichour render a --spp", "--spp needs a value N"},
        {"magichour render a --spp 0", "--spp: 0 is outside the range from 1 to 16777216"},
        {"magichour render a --spp 1.5", "'1.5' is not a whole number"},
        {"magichour render a --spp 5000000000", "--spp: 5000000000 is outside the range from 1 to 16777216"},
        {"magichour render a --size 0x0", "at least 1x1"},
        {"magichour render a --size 10", "'10' is not WIDTHxHEIGHT"},
        {"magichour render a --size 10x", "not WIDTHxHEIGHT"},
        {"magichour render a --size -1x5", "not WIDTHxHEIGHT"},
        {"magichour render a --sun nan", "'nan' is not a number, and one from -90 to 90 is needed"},
        {"magichour render a --sun 91", "--sun: 91 is outside the range from -90 to 90"},
        {"magichour render a --sun 5,", "'' is not a number"},
        {"magichour render a --sun 5,400", "--sun: 400 is outside the range from -360 to 360"},
        {"magichour render a --sun 5,90,7", "--sun: '5,90,7' is not EL or EL,AZ"},
        {"magichour render a --spp -1", "--spp: -1 is outside the range from 1"},
        {"magichour render a --spp 99999999999999999999", "is outside the range from 1"},
        {"magichour render a --spp 64k", "'64k' is not a whole number, and one from 1"},
        {"magichour render a --size 10x20x30", "not WIDTHxHEIGHT"},
        {"magichour render a --error 2level",
         "'2level' is neither percent, such as 1, nor levels, such as 2levels"},
        {"magichour render a --error 200levels", "200 is outside the range from 0.01 to 100"},
        {"magichour render a --error 1%", "'1%' is neither percent"},
        {"magichour render a --time 5s", "'5s' is not a number"},
        {"magichour render a --set ball", "'ball' is not NAME=VALUE"},
        {"magichour render a --set =3", "not NAME=VALUE"},
        {"magichour render a --quiet=1", "--quiet takes no value"},
        {"magichour render a --progress loud", "unknown 'loud' (known: tty, lines, json, none)"},
        {"magichour render a --progress jsno", "unknown 'jsno': did you mean json? (known"},
        {"magichour view a --progress tty", "unknown 'tty' (known: json, none)"},
        {"magichour render a --exposure inf", "'inf' is not a number"},
        {"magichour compare a b --max-bias x", "'x' is not a number"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Options options;
        Error error = {0};
        assert_false(parse(&options, cases[i].line, &error));
        assert_int_equal(error.status, STATUS_USAGE);
        if (!strstr(error.text, cases[i].part)) fail_msg("%s: %s", cases[i].line, error.text);
    }
}

/* Every usual way to ask for help or the version, with or without the rest of a command's words. */
static void test_help_asked(void **state) {
    (void)state;
    static const struct {
        const char *line;
        Command command;
    } help[] = {
        {"magichour --help", COMMAND_NONE},
        {"magichour -h", COMMAND_NONE},
        {"magichour help", COMMAND_NONE},
        {"magichour render --help", COMMAND_RENDER},
        {"magichour render -h", COMMAND_RENDER},
        {"magichour help render", COMMAND_RENDER},
        {"magichour help sky", COMMAND_SKY},
        {"magichour --help sky", COMMAND_SKY},
        {"magichour -h render", COMMAND_RENDER},
        {"magichour version -h", COMMAND_VERSION},
        {"magichour compare a b -h c", COMMAND_COMPARE},
        {"magichour help help", COMMAND_HELP},
        {"magichour help -h", COMMAND_HELP},
        {"magichour render a -h --frob", COMMAND_RENDER},
    };
    static const char *const version[] = {"magichour --version", "magichour render --version",
                                          "magichour help --version", "magichour version"};
    Options options;
    Error error;
    for (size_t i = 0; i < sizeof help / sizeof *help; i++) {
        if (!parse(&options, help[i].line, &error)) fail_msg("%s: %s", help[i].line, error.text);
        assert_true(options.help && !options.version);
        assert_int_equal(options.command, help[i].command);
    }
    for (size_t i = 0; i < sizeof version / sizeof *version; i++) {
        if (!parse(&options, version[i], &error)) fail_msg("%s: %s", version[i], error.text);
        assert_true(options.version && !options.help);
    }
}

static size_t longest_line(const char *text) {
    size_t longest = 0;
    for (; *text; text += strcspn(text, "\n"), text += *text == '\n') {
        if (strcspn(text, "\n") > longest) longest = strcspn(text, "\n");
    }
    return longest;
}

/* The text without the ways that it is broken into lines. */
static void join_words(Text *text) {
    char *to = text->data;
    for (const char *from = text->data; *from; from++) {
        bool blank = *from == ' ' || *from == '\n';
        if (!blank || (to > text->data && to[-1] != ' ')) *to++ = blank ? ' ' : *from;
    }
    *to = 0;
}

/* The help of each command names each of its options with its words, and no other command's, and keeps within
 * the terminal. */
static void test_help(void **state) {
    (void)state;
    static const int widths[] = {48, 64, 80, 132};
    for (int c = 0; c < command_table_size; c++) {
        for (size_t w = 0; w < sizeof widths / sizeof *widths; w++) {
            Text text = {0};
            help_print(command_table[c].command, widths[w], &text);
            /* The first line is the usage, to be copied as it stands. */
            assert_true(longest_line(strchr(text.data, '\n') + 1) <= (size_t)widths[w]);
            join_words(&text);
            for (int i = 0; i < option_table_size; i++) {
                const OptionRow *row = &option_table[i];
                bool named = strstr(text.data, row->help) != NULL;
                if (named != ((row->commands & (int)command_table[c].command) != 0))
                    fail_msg("%s at %d columns, %s: %s", command_table[c].name, widths[w], row->name,
                             row->help);
            }
            text_free(&text);
        }
    }
    Text text = {0};
    help_print(COMMAND_NONE, 80, &text);
    assert_true(longest_line(text.data) <= 80);
    join_words(&text);
    for (int c = 0; c < command_table_size; c++) assert_non_null(strstr(text.data, command_table[c].about));
    text_free(&text);
}

/* Groups stand in one order under their headings, and none is empty. */
static void test_help_groups(void **state) {
    (void)state;
    Text text = {0};
    help_print(COMMAND_RENDER, 80, &text);
    const char *last = text.data;
    for (int group = 0; group < OPTION_GROUPS; group++) {
        char heading[40];
        snprintf(heading, sizeof heading, "\n\n%s\n  -", option_group_names[group]);
        const char *found = strstr(text.data, heading);
        assert_non_null(found);
        assert_true(found > last);
        last = found;
    }
    text_free(&text);
    help_print(COMMAND_INFO, 80, &text);
    assert_null(strstr(text.data, "Methods"));
    text_free(&text);
}

static void test_manual(void **state) {
    (void)state;
    Text text = {0};
    manual_print(&text);
    assert_int_equal(strncmp(text.data, ".TH MAGICHOUR 1 ", 16), 0);
    assert_non_null(
        strstr(text.data, "\n.B \\-\\-size WxH\npicture size in pixels; 256x256 by default\n(chart)\n"));
    assert_non_null(strstr(text.data, "\n.B 130\n"));
    /* A line that starts with a dot is a macro, or else it would be lost. */
    for (const char *line = text.data; (line = strstr(line, "\n.")); line++)
        assert_true(strncmp(line + 2, "S", 1) == 0 || strncmp(line + 2, "TP\n", 3) == 0 ||
                    strncmp(line + 2, "B ", 2) == 0 || strncmp(line + 2, "I ", 2) == 0);
    static const char *const sections[] = {"NAME",        "SYNOPSIS",    "COMMANDS", "OPTIONS",
                                           "EXIT STATUS", "ENVIRONMENT", "FILES",    "EXAMPLES"};
    const char *at = text.data;
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++) {
        char heading[40];
        snprintf(heading, sizeof heading, "\n.SH %s\n", sections[i]);
        at = strstr(at, heading);
        if (!at) fail_msg("no %s in its place", sections[i]);
    }
    for (int group = 0; group < OPTION_GROUPS; group++) {
        char heading[40];
        snprintf(heading, sizeof heading, "\n.SS %s\n.TP\n", option_group_names[group]);
        assert_non_null(strstr(text.data, heading));
    }
    text_free(&text);
}

/* mandoc finds nothing to complain about. The page has no date, as it is made again from the same text. */
static void test_manual_lint(void **state) {
    (void)state;
    Text text = {0};
    char command[512];
    if (system("command -v mandoc >/dev/null 2>&1") != 0) {
        print_message("mandoc is not installed: the manual page is not checked by it\n");
        skip();
    }
    manual_print(&text);
    snprintf(command, sizeof command, "mandoc -Tlint '%s' | grep -v 'missing date'",
             support_write("magichour.1", text.data));
    assert_int_equal(WEXITSTATUS(system(command)), 1);
    text_free(&text);
}

/* As it is run: what is asked for is standard output, and the status is 0. */
static void test_help_run(void **state) {
    (void)state;
    assert_int_equal(support_run("", "render -h"), 0);
    assert_non_null(strstr(support_out, "--sun-disk[=METHOD]"));
    assert_int_equal(support_run("", "help"), 0);
    assert_non_null(strstr(support_out, "explain"));
    assert_int_equal(support_run("", "render --version"), 0);
    assert_int_equal(strncmp(support_out, "magichour ", 10), 0);
    assert_int_equal(support_run("", "help --man"), 0);
    assert_int_equal(strncmp(support_out, ".TH ", 4), 0);
    assert_int_equal(support_run("", "render --sundisk"), 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_options),        cmocka_unit_test(test_option_forms),
        cmocka_unit_test(test_sun_disk_forms), cmocka_unit_test(test_options_refused),
        cmocka_unit_test(test_help_asked),     cmocka_unit_test(test_help),
        cmocka_unit_test(test_help_groups),    cmocka_unit_test(test_manual),
        cmocka_unit_test(test_manual_lint),    cmocka_unit_test(test_help_run),
    };
    return cmocka_run_group_tests_name("options", tests, support_folder, support_clean);
}
