/* The command line as one struct. Which option belongs to which command, its ranges and its help stand in one
 * table in options.c. */
#pragma once

#include "base/error.h"

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
    COMMAND_EXPLAIN = 1 << 7
} Command;

/* Absent options are NULL, 0 or false, unless said otherwise. Strings are argv's own. */
typedef struct Options {
    Command command;
    const char *inputs[2];
    int input_count;
    const char *outputs[8];
    int output_count;
    bool help, version;

    int width, height;
    bool has_sun, has_azimuth;
    double sun_elevation_deg, sun_azimuth_deg;
    const char *preset, *atmosphere, *sky, *light, *sequence, *backend, *glsl_dir;
    const char *settings[64]; /* "NAME=VALUE" */
    int setting_count;
    unsigned long long samples;
    double seconds, error_percent; /* 0 when absent */
    const char *charts;            /* "paths,sky" */
    unsigned seed;
    int depth;
    bool has_exposure;
    double exposure_ev;
    const char *tone, *progress, *at;
    const char *record;   /* folder */
    const char *aov;      /* "albedo,depth" */
    const char *sun_disk; /* the method that finds the sun's disk */
    bool quiet, verbose;

    double max_relrmse_percent, max_bias_percent; /* infinite when absent */
    const char *standard_error, *mask;
} Options;

MUST_CHECK bool options_parse(Options *options, int argc, char **argv, Error *error);

/* The help text of a command, or of the program (COMMAND_NONE). */
void options_print_help(Command command);
