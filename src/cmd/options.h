/* The command line as one struct. The table of options (option_table.c) holds their help and which commands
 * take them. */
#pragma once

#include "base/error.h"
#include "error/promise.h"

#include <stddef.h>

typedef enum Command {
    COMMAND_NONE = 0,
    COMMAND_RENDER = 1 << 0,
    COMMAND_COMPARE = 1 << 1,
    COMMAND_INFO = 1 << 2,
    COMMAND_FLATTEN = 1 << 3,
    COMMAND_SKY = 1 << 4,
    COMMAND_VIEW = 1 << 5,
    COMMAND_CHART = 1 << 6,
    COMMAND_EXPLAIN = 1 << 7,
    COMMAND_HELP = 1 << 8,
    COMMAND_VERSION = 1 << 9,
    COMMAND_MERGE = 1 << 10,
    COMMAND_SWEEP = 1 << 11,
    COMMAND_EXPORT = 1 << 12,
    COMMAND_NEW = 1 << 13
} Command;

/* Files that a command may take: `merge` takes so many. */
enum { MOST_INPUTS = 1024 };

/* Options that were not given are NULL, 0 or false, unless it is said otherwise. Strings belong to argv. */
typedef struct Options {
    Command command;
    const char *inputs[MOST_INPUTS];
    int input_count;
    const char *outputs[8];
    int output_count;
    /* The format of the pictures; NULL where the outputs' endings name it. */
    const char *format;

    /* Whether the help of `command` is wanted, or the program's if that is COMMAND_NONE. */
    bool help;
    bool version, manual;
    /* The shell whose completion script is wanted, or NULL. */
    const char *completion;

    int width, height;
    bool has_sun, has_azimuth;
    double sun_elevation_deg, sun_azimuth_deg;
    /* Of `sweep`: "FROM..TO". */
    const char *sun_range;
    /* The moment and the place that say where the sun stands. */
    const char *when, *where;
    const char *preset, *atmosphere, *sky, *light, *sequence, *backend, *glsl_dir;

    /* Words such as "NAME=VALUE". */
    const char *settings[64];
    int setting_count;

    /* Folders whose files a scene may read. */
    const char *allowed[16];
    int allowed_count;

    unsigned long long samples;
    /* The number of the first sample, and whether it was given. */
    unsigned long long first_sample;
    bool has_first_sample;
    /* The samples of the whole picture, of which these are a part; 0 if it was not given. */
    unsigned long long of;
    /* The part of the picture that is rendered; empty for all of it. */
    Rectangle crop;
    /* Files of checkpoints, and seconds between them; 0 if it was not given. */
    const char *checkpoint, *resume;
    double checkpoint_seconds;
    double seconds;
    ErrorTarget error;

    /* A list of charts such as "paths,sky". */
    const char *charts;
    /* A CSV of points that other programs reached. */
    const char *points;

    /* Processor time that a driver may take to compile one shader; 0 for the default. */
    double compile_seconds;

    unsigned seed;
    int depth;
    bool has_exposure;
    double exposure_ev;
    const char *tone, *progress;

    /* The file of directions of `sky`. */
    const char *at;

    /* The wavelengths whose radiances `sky --at` writes; "auto" if the option has no list. */
    const char *spectrum;

    /* The folder for recorded frames, their number, and frames a second. */
    const char *record;
    int frames;
    double frame_rate;

    /* A list of layers such as "albedo,depth". */
    const char *aov;

    /* Where to write the picture of the samples that were left out. */
    const char *nan_map;

    /* The method for the sun's disk; "auto" if the option has no word, or `on`. */
    const char *sun_disk;

    /* The orders of scattering, "all" or a number, and how those beyond the first are computed. */
    const char *orders, *further;

    /* For `export`: the texts for Shadertoy in place of a page. */
    bool shadertoy;

    bool quiet, verbose;
    /* Whether the files of the shader are listed. */
    bool files;

    /* For `flatten`: print every program of a picture, as text or as JSON lines. */
    bool all;
    /* For `flatten` and `compare`. */
    bool json;

    /* Infinite if they were not given. */
    double max_relrmse_percent, max_bias_percent, max_levels;

    const char *standard_error, *mask;

    /* Bytes that pictures may take. */
    size_t max_memory;

    /* For `compare`: the pixels of the sun's own image are compared too. */
    bool with_sun;

    /* For `compare`: the layer of both pictures, or of A and of B. */
    const char *layers[2];
    int layer_count;

    /* For `merge`: the result cannot be merged again. */
    bool final;

    /* For `new`: "exact", "marched" or "shadertoy"; NULL for the first. */
    const char *kind;

    /* For `compare`: where to write both pictures and their difference. */
    const char *side_by_side;
} Options;
