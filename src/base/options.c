#include "base/options.h"

#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const struct {
    Command command;
    const char *name, *usage, *about;
    int min_inputs, max_inputs;
} commands[] = {
    {COMMAND_RENDER, "render", "render SCENE -o FILE [options]", "render a scene offscreen", 1, 1},
    {COMMAND_VIEW, "view", "view SCENE [options]", "a window: move the sun and the camera, edit the scene", 1,
     1},
    {COMMAND_SKY, "sky", "sky -o FILE | --at FILE.csv [options]",
     "the sky alone: a lat-long map, or listed directions", 0, 0},
    {COMMAND_COMPARE, "compare", "compare A B [options]", "errors of picture A against the reference B", 2,
     2},
    {COMMAND_INFO, "info", "info [SCENE] [options]", "backends, methods, atmospheres; a scene's parameters",
     0, 1},
    {COMMAND_FLATTEN, "flatten", "flatten SCENE [options]",
     "print the shader that a scene and its methods make", 1, 1},
    {COMMAND_CHART, "chart", "chart SCENE -o DIR [options]",
     "measure speed against accuracy on this machine, and draw it", 1, 1},
    {COMMAND_EXPLAIN, "explain", "explain SCENE [options]",
     "what a scene needs: the change and the cost of each term of the model", 1, 1},
};
enum { COMMANDS = sizeof commands / sizeof *commands };

typedef bool (*Take)(Options *options, const char *name, const char *value, Error *error);

static bool take_output(Options *options, const char *name, const char *value, Error *error) {
    enum { MOST = sizeof options->outputs / sizeof *options->outputs };
    if (options->output_count == MOST)
        return error_set(error, STATUS_USAGE, "%s more than %d times", name, MOST);
    options->outputs[options->output_count++] = value;
    return true;
}

static bool take_setting(Options *options, const char *name, const char *value, Error *error) {
    enum { MOST = sizeof options->settings / sizeof *options->settings };
    const char *equals = strchr(value, '=');
    if (!equals || equals == value || !equals[1]) {
        return error_set(error, STATUS_USAGE, "%s: '%s' is not NAME=VALUE", name, value);
    }
    if (options->setting_count == MOST)
        return error_set(error, STATUS_USAGE, "%s more than %d times", name, MOST);
    options->settings[options->setting_count++] = value;
    return true;
}

static bool take_size(Options *options, const char *name, const char *value, Error *error) {
    const char *cross = strchr(value, 'x');
    char width[16] = "";
    unsigned long long w, h;
    if (cross && cross - value < (long)sizeof width) memcpy(width, value, (size_t)(cross - value));
    if (!cross || !count_parse(width, &w) || !count_parse(cross + 1, &h) || w > 1000000000 ||
        h > 1000000000) {
        return error_set(error, STATUS_USAGE, "%s: '%s' is not WIDTHxHEIGHT", name, value);
    }
    /* 0 is how absence is marked: hand on a size that the check of limits refuses just as well. */
    options->width = w ? (int)w : -1;
    options->height = h ? (int)h : -1;
    if (!w || !h)
        return error_set(error, STATUS_USAGE, "%s: '%s': a picture has at least 1x1 pixels", name, value);
    return true;
}

static bool take_sun(Options *options, const char *name, const char *value, Error *error) {
    char elevation[64];
    const char *comma = strchr(value, ',');
    snprintf(elevation, sizeof elevation, "%.*s", comma ? (int)(comma - value) : (int)strlen(value), value);
    if (!number_parse_range(name, elevation, -90, 90, &options->sun_elevation_deg, error)) return false;
    options->has_sun = true;
    options->has_azimuth = comma != NULL;
    return !comma || number_parse_range(name, comma + 1, -360, 360, &options->sun_azimuth_deg, error);
}

static bool take_count(const char *name, const char *value, unsigned long long min, unsigned long long max,
                       unsigned long long *count, Error *error) {
    unsigned long long parsed;
    if (!count_parse(value, &parsed) || parsed < min || parsed > max) {
        return error_set(error, STATUS_USAGE, "%s: '%s' is not a whole number from %llu to %llu", name, value,
                         min, max);
    }
    *count = parsed;
    return true;
}

static bool take_samples(Options *options, const char *name, const char *value, Error *error) {
    return take_count(name, value, 1, 4294967295ULL, &options->samples, error);
}

static bool take_seed(Options *options, const char *name, const char *value, Error *error) {
    unsigned long long seed = 0;
    if (!take_count(name, value, 0, 4294967295ULL, &seed, error)) return false;
    options->seed = (unsigned)seed;
    return true;
}

static bool take_depth(Options *options, const char *name, const char *value, Error *error) {
    unsigned long long depth = 0;
    if (!take_count(name, value, 0, 1000000000, &depth, error)) return false;
    options->depth = (int)depth;
    return true;
}

static bool take_seconds(Options *options, const char *name, const char *value, Error *error) {
    return number_parse_range(name, value, 1e-3, 1e9, &options->seconds, error);
}

static bool take_error(Options *options, const char *name, const char *value, Error *error) {
    return number_parse_range(name, value, 1e-3, 1e3, &options->error_percent, error);
}

static bool take_exposure(Options *options, const char *name, const char *value, Error *error) {
    options->has_exposure = true;
    return number_parse_range(name, value, -64, 64, &options->exposure_ev, error);
}

static bool take_max_relrmse(Options *options, const char *name, const char *value, Error *error) {
    return number_parse_range(name, value, 0, 1e9, &options->max_relrmse_percent, error);
}

static bool take_max_bias(Options *options, const char *name, const char *value, Error *error) {
    return number_parse_range(name, value, 0, 1e9, &options->max_bias_percent, error);
}

/* An option of one of these words. */
static bool take_word(const char *name, const char *value, const char *const *words, const char **target,
                      Error *error) {
    Text known = {0};
    for (; *words; words++) {
        if (strcmp(*words, value) == 0) {
            text_free(&known);
            *target = *words;
            return true;
        }
        text_print(&known, "%s%s", known.size ? ", " : "", *words);
    }
    error_set(error, STATUS_USAGE, "%s: unknown '%s' (known: %s)", name, value, text_string(&known));
    text_free(&known);
    return false;
}

static bool take_tone(Options *options, const char *name, const char *value, Error *error) {
    static const char *const words[] = {"author", "none", NULL};
    return take_word(name, value, words, &options->tone, error);
}

static bool take_progress(Options *options, const char *name, const char *value, Error *error) {
    static const char *const words[] = {"tty", "json", "none", NULL};
    return take_word(name, value, words, &options->progress, error);
}

/* Options that keep their words or switch something on need no code of their own. */
typedef enum Kind { KIND_TAKE, KIND_STRING, KIND_FLAG, KIND_OPTIONAL } Kind;

typedef struct Option {
    const char *name, *argument; /* argument NULL for a flag, "[=WORD]" for one that takes a word or "auto" */
    int commands;
    Kind kind;
    Take take;
    size_t offset; /* of the string or flag in Options */
    const char *help;
} Option;

#define TAKE(name, argument, commands, take, help)                                                           \
    { name, argument, commands, KIND_TAKE, take, 0, help }
#define STRING(name, argument, commands, member, help)                                                       \
    { name, argument, commands, KIND_STRING, NULL, offsetof(Options, member), help }
#define OPTIONAL(name, argument, commands, member, help)                                                     \
    { name, argument, commands, KIND_OPTIONAL, NULL, offsetof(Options, member), help }
#define FLAG(name, commands, member, help)                                                                   \
    { name, NULL, commands, KIND_FLAG, NULL, offsetof(Options, member), help }

enum {
    R = COMMAND_RENDER,
    V = COMMAND_VIEW,
    C = COMMAND_COMPARE,
    I = COMMAND_INFO,
    F = COMMAND_FLATTEN,
    S = COMMAND_SKY,
    H = COMMAND_CHART,
    E = COMMAND_EXPLAIN
};

static const Option table[] = {
    TAKE("-o", "FILE", R | S, take_output, "write the picture: .exr, .png or .pfm; may be repeated"),
    TAKE("-o", "DIR", H, take_output, "the folder for CSV, SVG, PNG and the reference; made if need be"),
    TAKE("--size", "WxH", H, take_size, "picture size in pixels; 256x256 by default"),
    TAKE("--size", "WxH", E, take_size, "picture size in pixels; 128x128 by default"),
    TAKE("--size", "WxH", R | V | S, take_size, "picture size in pixels; the scene's by default"),
    TAKE("--sun", "EL[,AZ]", R | V | S | H | E, take_sun,
         "the sun's elevation and azimuth (from +z toward +x), degrees"),
    STRING("--preset", "NAME", R | V | F | H | E, preset, "one of the scene's presets"),
    STRING("--atmosphere", "NAME", R | V | S | F | I | H | E, atmosphere,
           "a preset of the atmosphere (see info)"),
    TAKE("--set", "NAME=VALUE", R | V | S | F | I | H | E, take_setting,
         "a scene's parameter, sun.elevation, atmosphere.mie_g, ...; may be repeated"),
    STRING("--sky", "METHOD", R | V | F | S, sky, "table[:METHOD], gauss[:n], paper[:NxM] or uniform[:L]"),
    STRING("--light", "METHOD", R | V | F, light,
           "control, cosine, mis or paper; by default mis for a low sun, control where the sky is a table "
           "and the "
           "scene has bounds, or else cosine"),
    STRING("--sequence", "METHOD", R | V | F, sequence, "sobol, additive or random; sobol by default"),
    TAKE("--error", "PERCENT", R, take_error,
         "stop when the estimated relRMSE is this; 1 by default, unless --spp or --time is given"),
    TAKE("--time", "SECONDS", R, take_seconds, "stop after this time, with whole groups of samples"),
    TAKE("--spp", "N", R, take_samples, "take so many samples of every pixel"),
    STRING("--charts", "LIST", H, charts, "some of paths,sky,scale; all by default"),
    TAKE("--time", "SECONDS", H, take_seconds,
         "to measure in, about; 150 by default, compilation not counted"),
    TAKE("--error", "PERCENT", H, take_error, "where auto's choice is marked; 1 by default"),
    TAKE("--error", "PERCENT", E, take_error, "what changes the picture by more is needed; 1 by default"),
    TAKE("--spp", "N", V, take_samples,
         "samples per pixel, after which the picture rests; a million by default"),
    STRING("--record", "DIR", V, record,
           "plays a day into DIR/frame-00001.png ..., 64 samples each if --spp is not given"),
    TAKE("--seed", "N", R | V, take_seed, "of all random numbers; 0 by default"),
    TAKE("--depth", "N", R | V | H | E, take_depth, "at most N surface hits; 0, the default, is unlimited"),
    TAKE("--exposure", "EV", R | V | S, take_exposure,
         "for .png: radiance times 2^EV; the scene's by default"),
    TAKE("--tone", "CURVE", R | S, take_tone, "for .png: author or none; author by default"),
    STRING("--backend", "NAME", R | I | S | H | E, backend, "auto, egl, osmesa or glfw"),
    STRING("--glsl-dir", "DIR", R | V | I | F | S | H | E, glsl_dir,
           "the GLSL library, in place of the one beside the program"),
    STRING("--aov", "LIST", R, aov, "layers of .exr, some of albedo,normal,depth,samples,variance"),
    TAKE("--progress", "KIND", R | V | H | E, take_progress,
         "tty, json or none; tty on a terminal, else none (view: json or none)"),
    STRING("--at", "FILE.csv", S, at,
           "radiances for rows height_m,sun_el_deg,view_el_deg,az_deg (azimuth from the sun's), as CSV"),
    OPTIONAL("--sun-disk", "[=METHOD]", R | V | F | S | H | E, sun_disk,
             "the sun itself, 0.2666 degrees in radius: sampled, chance or off; on if a scene says so"),
    FLAG("--quiet", R | S | H | E, quiet, "no summary, no progress"),
    FLAG("-v", R, verbose, "say what is chosen and why"),
    TAKE("--max-relrmse", "PERCENT", C, take_max_relrmse, "exit with 6 if the relRMSE is above this"),
    TAKE("--max-bias", "PERCENT", C, take_max_bias, "exit with 6 if a channel's bias is beyond this"),
    STRING("--se", "FILE", C, standard_error,
           "standard errors of the difference: prints mean z^2 and the share of |z| > 4"),
    STRING("--mask", "FILE", C, mask, "compare only where this picture's red is above 0.5"),
    FLAG("--help", R | V | C | I | F | S | H | E, help, "this text"),
};
enum { TABLE = sizeof table / sizeof *table };

static const Option *find_option(const char *name, size_t length, Command command) {
    for (int i = 0; i < TABLE; i++) {
        if (strlen(table[i].name) == length && strncmp(table[i].name, name, length) == 0 &&
            (table[i].commands & (int)command)) {
            return &table[i];
        }
    }
    return NULL;
}

static bool take_option(Options *options, const Option *option, const char *value, Error *error) {
    void *target = (char *)options + option->offset;
    switch (option->kind) {
    case KIND_FLAG:
        *(bool *)target = true;
        return true;
    case KIND_STRING:
        *(const char **)target = value;
        return true;
    case KIND_OPTIONAL:
        *(const char **)target = value ? value : "auto";
        return true;
    case KIND_TAKE:
        return option->take(options, option->name, value, error);
    }
    return false;
}

/* argv[*at] is an option; moves *at over its value. */
static bool parse_option(Options *options, int argc, char **argv, int *at, int command, Error *error) {
    const char *word = argv[*at];
    const char *equals = strncmp(word, "--", 2) == 0 ? strchr(word, '=') : NULL;
    size_t length = equals ? (size_t)(equals - word) : strlen(word);
    const Option *option = find_option(word, length, options->command);
    if (!option) {
        return error_set(error, STATUS_USAGE, "unknown option '%.*s' (see magichour %s --help)", (int)length,
                         word, commands[command].name);
    }
    const char *value = equals ? equals + 1 : NULL;
    if (option->kind == KIND_FLAG && value) {
        return error_set(error, STATUS_USAGE, "%s takes no value", option->name);
    }
    if (option->kind != KIND_FLAG && option->kind != KIND_OPTIONAL && !value) {
        if (*at + 1 >= argc)
            return error_set(error, STATUS_USAGE, "%s needs a value %s", option->name, option->argument);
        value = argv[++*at];
    }
    return take_option(options, option, value, error);
}

static int find_command(const char *name) {
    for (int i = 0; i < COMMANDS; i++) {
        if (strcmp(commands[i].name, name) == 0) return i;
    }
    return -1;
}

bool options_parse(Options *options, int argc, char **argv, Error *error) {
    *options = (Options){.max_relrmse_percent = INFINITY, .max_bias_percent = INFINITY};
    if (argc < 2) return error_set(error, STATUS_USAGE, "which command? (see magichour --help)");
    options->help = strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0;
    options->version = strcmp(argv[1], "--version") == 0;
    if (options->help || options->version) return true;
    int command = find_command(argv[1]);
    if (command < 0)
        return error_set(error, STATUS_USAGE, "unknown command '%s' (see magichour --help)", argv[1]);
    options->command = commands[command].command;
    bool only_inputs = false;
    for (int i = 2; i < argc; i++) {
        if (!only_inputs && strcmp(argv[i], "--") == 0) {
            only_inputs = true;
        } else if (!only_inputs && argv[i][0] == '-' && argv[i][1]) {
            if (!parse_option(options, argc, argv, &i, command, error)) return false;
        } else if (options->input_count == commands[command].max_inputs) {
            return error_set(error, STATUS_USAGE, "'%s' is one file too many (usage: magichour %s)", argv[i],
                             commands[command].usage);
        } else {
            options->inputs[options->input_count++] = argv[i];
        }
    }
    if (!options->help && options->input_count < commands[command].min_inputs) {
        return error_set(error, STATUS_USAGE, "usage: magichour %s", commands[command].usage);
    }
    return true;
}

void options_print_help(Command command) {
    if (command == COMMAND_NONE) {
        puts("magichour: a progressive renderer for small scenes under a physical sky\n");
        for (int i = 0; i < COMMANDS; i++)
            printf("  magichour %-34s %s\n", commands[i].usage, commands[i].about);
        puts("\nmagichour COMMAND --help lists a command's options; magichour --version tells the version.\n"
             "Exit status: 0 done, 1 failure while running, 2 usage, 3 scene or shader, 4 no OpenGL,\n"
             "5 output not written, 6 comparison past its bound, 130 interrupted with the picture saved.");
        return;
    }
    for (int i = 0; i < COMMANDS; i++) {
        if (commands[i].command == command)
            printf("magichour %s\n%s\n\n", commands[i].usage, commands[i].about);
    }
    for (int i = 0; i < TABLE; i++) {
        if (!(table[i].commands & (int)command)) continue;
        char left[40];
        snprintf(left, sizeof left, "%s%s%s", table[i].name, table[i].kind == KIND_OPTIONAL ? "" : " ",
                 table[i].argument ? table[i].argument : "");
        printf("  %-24s %s\n", left, table[i].help);
    }
}
