/* The completion of command lines: what the program offers, and each shell with the script that is made for
 * it, as a user types. A shell that is not installed is skipped. */
#include "support.h"
#include "terminal.h"

#include "cmd/complete.h"
#include "cmd/completion_scripts.h"
#include "cmd/option_table.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What the last of the words between blanks may become. A line that ends with a blank has an empty last word.
 */
static const char *offered(const char *line) {
    static Text text;
    static char words[512];
    char *list[32];
    int count = 0;
    text_free(&text);
    snprintf(words, sizeof words, "%s", line);
    for (char *at = words; at; count++) {
        list[count] = at;
        at = strchr(at, ' ');
        if (at) *at++ = 0;
    }
    complete_print(count, list, &text);
    return text_string(&text);
}

static void expect_offer(const char *line, const char *reply, bool wanted) {
    char start[256];
    snprintf(start, sizeof start, "\n%s", reply);
    Text text = {0};
    text_print(&text, "\n%s", offered(line));
    bool found = strstr(text.data, start) != NULL;
    if (found != wanted) fail_msg("'%s' %s '%s': %s", line, found ? "offers" : "lacks", reply, text.data);
    text_free(&text);
}

static void test_offers(void **state) {
    (void)state;
    static const struct {
        const char *line, *reply;
    } cases[] = {
        {"", "render\t"},
        {"re", "render\t"},
        {"--v", "--version\n"},
        {"render ", "crater\tCrater\n"},
        {"render ", ":files\n"},
        {"render cr", "crater\t"},
        {"render crater --sk", "--sky\t"},
        {"render crater --sky ", "gauss:8\t"},
        {"render crater --sky=tab", "--sky=table\t"},
        {"render crater --light ", "auto\t"},
        {"render crater --light co", "cosine\t"},
        {"render crater --further=", "--further=harmonics:14\t"},
        {"render crater --preset ", "twilight\n"},
        {"render crater --preset=tw", "--preset=twilight\n"},
        {"render scenes/crater.glsl --preset su", "sunset\n"},
        {"render crater --set b", "ball=\t"},
        {"render crater --set ball=", "ball=1\t"},
        {"render crater --set atmosphere.m", "atmosphere.mie_g=\t"},
        {"render crater --set atmosphere.orders=", "atmosphere.orders=all\n"},
        {"sky --set camera.", "camera.fov=\n"},
        {"render crater --atmosphere ", "earth\t"},
        {"render crater --backend e", "egl\n"},
        {"render crater --tone ", "author\n"},
        {"render crater --progress j", "json\n"},
        {"render crater --aov albedo,de", "albedo,depth\n"},
        {"render crater --sun-disk ", "on\t"},
        {"render crater --sun-disk ", "chance\t"},
        {"render --sun-disk ", "crater\t"},
        {"render crater --out", "--output\t"},
        {"render crater -o ", ":files\n"},
        {"chart crater -o ", ":folders\n"},
        {"view crater --record=", ":folders\n"},
        {"compare a.exr ", ":files\n"},
        {"sky --sky ref", "reference\t"},
        {"help sk", "sky\t"},
        {"help --completion z", "zsh\n"},
        {"--help fl", "flatten\t"},
    };
    static const struct {
        const char *line, *reply;
    } never[] = {
        {"render crater ", ":files"},
        {"render crater --s", "--side-by-side"},
        {"render cr", "arches"},
        {"render crater --preset ", "crater"},
        {"render crater --sky co", "cosine"},
        {"render -- --s", "--sky"},
        {"compare --s", "--sky"},
        {"render crater --aov albedo,", "albedo,albedo"},
        {"render crater --sky ", "reference"},
        {"render crater --spp ", ""},
        {"render crater --set ball=", "ball=\t"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        expect_offer(cases[i].line, cases[i].reply, true);
    for (size_t i = 0; i < sizeof never / sizeof *never; i++) {
        if (!*never[i].reply) assert_string_equal(offered(never[i].line), "");
        if (*never[i].reply) expect_offer(never[i].line, never[i].reply, false);
    }
}

/* Each option of each command, and each word that the table gives it is one that the command line takes. */
static void test_whole_table(void **state) {
    (void)state;
    char line[128], reply[128];
    for (int c = 0; c < command_table_size; c++) {
        for (int i = 0; i < option_table_size; i++) {
            const OptionRow *row = &option_table[i];
            snprintf(line, sizeof line, "%s -", command_table[c].name);
            snprintf(reply, sizeof reply, "%s\t", row->name);
            bool there = option_find(row->name, strlen(row->name), command_table[c].command) != NULL;
            expect_offer(line, reply, there);
        }
    }
    support_expect(0, "", "render scenes/crater.glsl --size 8x8 --spp 1 --quiet -o '%s' --aov %s",
                   support_path("all.exr"), "albedo,normal,depth,samples");
}

/* The line that the shell has when `typed` was typed and the tabulator pressed. The program is found as
 * `magichour`. */
static void expect_line(const Terminal *terminal, const char *typed, const char *whole) {
    char text[8192];
    terminal_type(terminal, typed);
    /* To the line's start, where a command is put that prints its words, and to its end. */
    terminal_type(terminal, "\t\001printf '%s\\n' S''TART \005 E''ND\n");
    if (!terminal_await(terminal, "\nEND\r", 30, text, sizeof text))
        fail_msg("'%s': no answer: %s", typed, text);
    char *answer = strstr(text, "START\r\n");
    if (!answer) fail_msg("'%s': %s", typed, text);
    Text joined = {0};
    char *end = strstr(answer, "\nEND\r");
    for (char *c = answer + 7; c < end; c++) {
        if (*c != '\r') text_print(&joined, "%c", *c == '\n' ? ' ' : *c);
    }
    /* zsh takes back the slash behind a folder where a blank follows. */
    if (joined.size && joined.data[joined.size - 1] == '/') joined.data[--joined.size] = 0;
    if (strcmp(text_string(&joined), whole) != 0) fail_msg("'%s': '%s', not '%s'", typed, joined.data, whole);
    text_free(&joined);
}

/* Whether the shell is installed. */
static bool has(const char *shell) {
    char line[64];
    snprintf(line, sizeof line, "command -v %s >/dev/null 2>&1", shell);
    return system(line) == 0;
}

static void skip_without(const char *shell) {
    if (has(shell)) return;
    print_message("%s is not installed: its completion is not tested\n", shell);
    skip();
}

/* A folder with a link to the program, and the script. */
static const char *prepare(const char *shell, const char *script_name) {
    char command[1024];
    const char *program = getenv("MAGICHOUR");
    snprintf(command, sizeof command, "mkdir -p '%s' && ln -sf \"$(realpath '%s')\" '%s/magichour'",
             support_path("bin"), program ? program : "build/magichour", support_path("bin"));
    assert_int_equal(system(command), 0);
    return support_write(script_name, completion_script(shell));
}

/* Types the same lines at a shell that edits lines as Emacs does. */
static void type_lines(const char *command, const char *start) {
    static const char *const lines[][2] = {
        {"magichour rend", "magichour render"},
        {"magichour help fla", "magichour help flatten"},
        {"magichour render crat", "magichour render crater"},
        {"magichour render crater --atmos", "magichour render crater --atmosphere"},
        {"magichour render crater --light consi", "magichour render crater --light consi"},
        {"magichour render crater --light cosi", "magichour render crater --light cosine"},
        {"magichour render crater --light=cosi", "magichour render crater --light=cosine"},
        {"magichour render crater --sky gauss:1", "magichour render crater --sky gauss:12"},
        {"magichour render crater --sky=gauss:1", "magichour render crater --sky=gauss:12"},
        {"magichour render crater --preset twi", "magichour render crater --preset twilight"},
        {"magichour render crater --set even", "magichour render crater --set even_albedo="},
        {"magichour render crater --set atmosphere.orders=a",
         "magichour render crater --set atmosphere.orders=all"},
        {"magichour render crater --atmosphere=ea", "magichour render crater --atmosphere=earth"},
        {"magichour render ./a_sc", "magichour render ./a_scene.glsl"},
        {"magichour view crater --record ./fram", "magichour view crater --record ./frames"},
        {"magichour view crater --record=./fram", "magichour view crater --record=./frames"},
    };
    Terminal terminal;
    char line[1024], text[8192];
    terminal_open(&terminal, 200);
    support_write("a_scene.glsl", "");
    snprintf(line, sizeof line,
             "mkdir -p '%s'; cd '%s' && TERM=xterm HISTFILE= PATH=\"$PWD/bin:$PATH\" %s <%s >%s 2>&1 &",
             support_path("frames"), support_path(""), command, terminal.name, terminal.name);
    assert_int_equal(system(line), 0);
    snprintf(line, sizeof line, "%s; echo REA''DY\n", start);
    terminal_type(&terminal, line);
    if (!terminal_await(&terminal, "READY\r", 60, text, sizeof text))
        fail_msg("%s does not start: %s", command, text);
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        expect_line(&terminal, lines[i][0], lines[i][1]);
    terminal_type(&terminal, "exit\n");
    terminal_await(&terminal, "exit", 1, text, sizeof text);
    terminal_close(&terminal);
}

static void test_bash(void **state) {
    (void)state;
    char start[1024];
    skip_without("bash");
    snprintf(start, sizeof start, "source '%s'", prepare("bash", "magichour.bash"));
    type_lines("bash --norc --noprofile -i", start);
}

/* As a file of the folder from which zsh takes its functions, which is how it is installed. */
static void test_zsh(void **state) {
    (void)state;
    char start[1024];
    skip_without("zsh");
    prepare("zsh", "_magichour");
    snprintf(start, sizeof start,
             "fpath=('%s' $fpath); autoload -Uz compinit; compinit -u -D; bindkey -e; unsetopt beep",
             support_path(""));
    type_lines("zsh -f -i", start);
}

/* fish says itself what it would offer. */
static void test_fish(void **state) {
    (void)state;
    static const char *const lines[][2] = {
        {"magichour rend", "render\t"},
        {"magichour render crat", "crater\tCrater"},
        {"magichour render crater --sky=gauss:1", "--sky=gauss:12\t"},
        {"magichour render crater --preset twi", "twilight"},
        {"magichour render crater --set even", "even_albedo=\t"},
        {"magichour render ./a_sc", "./a_scene.glsl"},
        {"magichour view crater --record ./fram", "./frames/"},
    };
    char command[1024];
    skip_without("fish");
    const char *script = prepare("fish", "magichour.fish"), *out = support_path("said");
    support_write("a_scene.glsl", "");
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        snprintf(command, sizeof command,
                 "mkdir -p '%s'; cd '%s' && HOME=\"$PWD/bin\" PATH=\"$PWD/bin:$PATH\" fish --no-config -c "
                 "\"source %s; complete -C "
                 "'%s'\" >'%s' 2>&1 && grep -qF -e '%s' '%s'",
                 support_path("frames"), support_path(""), script, lines[i][0], out, lines[i][1], out);
        if (system(command) != 0) fail_msg("%s", lines[i][0]);
    }
}

static int clean(void **state) {
    char command[1024];
    snprintf(command, sizeof command, "rm -rf '%s' '%s'", support_path("bin"), support_path("frames"));
    return system(command) != 0 || support_clean(state);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_offers), cmocka_unit_test(test_whole_table), cmocka_unit_test(test_bash),
        cmocka_unit_test(test_zsh),    cmocka_unit_test(test_fish),
    };
    return cmocka_run_group_tests_name("completion", tests, support_folder, clean);
}
