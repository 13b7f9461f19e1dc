#include "cmd/option_table.h"

#include <string.h>

const char *const option_group_names[OPTION_GROUPS] = {"Output", "Sun and sky", "Accuracy", "Methods",
                                                       "Other"};

enum {
    R = COMMAND_RENDER,
    V = COMMAND_VIEW,
    C = COMMAND_COMPARE,
    I = COMMAND_INFO,
    F = COMMAND_FLATTEN,
    S = COMMAND_SKY,
    H = COMMAND_CHART,
    E = COMMAND_EXPLAIN,
    M = COMMAND_MERGE,
    W = COMMAND_SWEEP,
    X = COMMAND_EXPORT,
    N = COMMAND_NEW,
    ALL = R | N | X | M | W | V | C | I | F | S | H | E | COMMAND_HELP | COMMAND_VERSION
};

/* These are a row's kind, function, offset and words. */
#define TAKE(function) OPTION_TAKE, function, 0, NULL
#define STRING(member) OPTION_STRING, NULL, offsetof(Options, member), NULL
#define WORD(member, words) OPTION_WORD, NULL, offsetof(Options, member), words
#define LIST(member, words) OPTION_STRING, NULL, offsetof(Options, member), words
#define OPTIONAL(member) OPTION_OPTIONAL, NULL, offsetof(Options, member), NULL
#define SWITCH(member) OPTION_SWITCH, NULL, offsetof(Options, member), NULL
#define FLAG(member) OPTION_FLAG, NULL, offsetof(Options, member), NULL

const OptionRow option_table[] = {
    {GROUP_OUTPUT, "-o", "FILE", R | S | M, TAKE(take_output),
     "write the picture: .exr, .png or .pfm; - is standard output; may be repeated", "--output"},
    {GROUP_OUTPUT, "--format", "FORMAT", R | S | M, WORD(format, "exr,png,pfm"),
     "exr, png or pfm: the format of an -o that names none, such as -, and of a single -o whatever its "
     "ending",
     NULL},
    {GROUP_OUTPUT, "-o", "FILE", C, TAKE(take_output),
     "write the difference in false colours, with its scale: .png; - is standard output; may be repeated",
     "--output"},
    {GROUP_OUTPUT, "--format", "FORMAT", C, WORD(format, "png"), "png, the only format of false colours",
     NULL},
    {GROUP_OUTPUT, "--side-by-side", "FILE", C, STRING(side_by_side),
     "write A, B and the difference beside each other: .png", NULL},
    {GROUP_OUTPUT, "-o", "DIR", W, TAKE(take_output),
     "the folder for the frames and for `jobs`, the list of their renders; made if need be", "--output"},
    {GROUP_OUTPUT, "-o", "FILE.html|DIR", X, TAKE(take_output),
     "the page; or with --shadertoy the folder of the texts, made if need be", "--output"},
    {GROUP_OUTPUT, "--shadertoy", NULL, X, FLAG(shadertoy),
     "write common.glsl, buffer-a.glsl and image.glsl for the tabs of shadertoy.com in place of a page",
     NULL},
    {GROUP_OUTPUT, "--frames", "N", W, TAKE(take_frames), "so many frames; 100 by default", NULL},
    {GROUP_OUTPUT, "--fps", "F", W, TAKE(take_frame_rate), "frames a second of the film; 25 by default",
     NULL},
    {GROUP_OUTPUT, "-o", "DIR", H, TAKE(take_output),
     "the folder for CSV, SVG, PNG and the reference; made if need be", "--output"},
    {GROUP_OUTPUT, "--size", "WxH", H, TAKE(take_size), "picture size in pixels; 256x256 by default", NULL},
    {GROUP_OUTPUT, "--size", "WxH", E, TAKE(take_size), "picture size in pixels; 128x128 by default", NULL},
    {GROUP_OUTPUT, "--size", "WxH", R | V | S | X, TAKE(take_size),
     "picture size in pixels; the scene's by default", NULL},
    {GROUP_OUTPUT, "--exposure", "EV", R | V | S, TAKE(take_exposure),
     "for .png: radiance times 2^EV; the scene's by default", NULL},
    {GROUP_OUTPUT, "--tone", "CURVE", R | S | M, WORD(tone, "author,none"),
     "for .png: author or none; author by default", NULL},
    {GROUP_OUTPUT, "--exposure", "EV", M, TAKE(take_exposure),
     "for .png: radiance times 2^EV; that of the first picture by default", NULL},
    {GROUP_OUTPUT, "--exposure", "EV", C, TAKE(take_exposure),
     "for levels: radiance times 2^EV; by default that of B's metadata (of A's if only A is a PNG), or 0",
     NULL},
    {GROUP_OUTPUT, "--tone", "CURVE", C, WORD(tone, "author,none"),
     "for levels: author or none; author by default", NULL},
    {GROUP_OUTPUT, "--aov", "LIST", R, LIST(aov, "albedo,normal,depth,samples,variance,transmittance"),
     "layers of .exr, some of albedo, normal, depth, samples, variance and transmittance, with commas", NULL},
    {GROUP_OUTPUT, "--nan-map", "FILE.exr", R, STRING(nan_map),
     "write where samples were left out: the number of them in each pixel, a layer for each cause", NULL},
    {GROUP_OUTPUT, "--record", "DIR", V, STRING(record),
     "write DIR/frame-00001.png ... and end: of a scene a day, 64 samples each if --spp is not given; of a "
     "file with "
     "mainImage() ten seconds of its iTime",
     NULL},
    {GROUP_OUTPUT, "--frames", "N", V, TAKE(take_frames), "for --record: write so many frames", NULL},
    {GROUP_OUTPUT, "--frames", "N", R, TAKE(take_frames),
     "of a file with mainImage(): draw so many frames, each of which has the one before as iChannel0, and "
     "write "
     "the last; 1 by default",
     NULL},
    {GROUP_OUTPUT, "--fps", "F", V, TAKE(take_frame_rate),
     "for --record: frames a second, 25 by default; a day takes an hour a second", NULL},
    {GROUP_OUTPUT, "--at", "FILE.csv", S, STRING(at),
     "radiances for rows height_m,sun_el_deg,view_el_deg,az_deg (azimuth from the sun's), as CSV", NULL},
    {GROUP_OUTPUT, "--spectrum", "[=LIST]", S, OPTIONAL(spectrum),
     "for --at: radiances of wavelengths in nm (400,550 or 360:830:10; those of atmosphere.spectrum if not "
     "given), W m-2 sr-1 nm-1, in place of R,G,B",
     NULL},
    {GROUP_OUTPUT, "--charts", "LIST", H, LIST(charts, "paths,sky,scale"),
     "some of paths,sky,scale; all by default", NULL},
    {GROUP_OUTPUT, "--points", "FILE.csv", H, STRING(points),
     "what other programs reached: rows program,seconds,percent, drawn beside the curves of the chart of "
     "paths",
     NULL},
    {GROUP_OUTPUT, "--all", NULL, F, FLAG(all),
     "every program of a picture, in the order in which they are drawn, each after a line with its name",
     NULL},
    {GROUP_OUTPUT, "--json", NULL, F, FLAG(json),
     "all of them as JSON lines, with the uniforms and the tables of each", NULL},
    {GROUP_OUTPUT, "--json", NULL, C, FLAG(json), "print the figures as one JSON line", NULL},
    {GROUP_OUTPUT, "--layer", "NAME", C, TAKE(take_layer),
     "the layer or part of both EXR files; given twice, that of A and then that of B ('' is the picture "
     "itself)",
     NULL},
    {GROUP_OUTPUT, "--mask", "FILE", C, STRING(mask), "compare only where this picture's red is above 0.5",
     NULL},
    {GROUP_OUTPUT, "--with-sun", NULL, C, FLAG(with_sun),
     "compare the pixels of the sun's own image too, which are left out by default", NULL},
    {GROUP_OUTPUT, "--final", NULL, M, FLAG(final),
     "leave out the sums that are needed to merge the result with others", NULL},
    {GROUP_OUTPUT, "--crop", "X,Y,W,H", R, TAKE(take_crop),
     "render these pixels of the picture alone: W columns from X on, H rows from Y on", NULL},
    {GROUP_OUTPUT, "--checkpoint", "FILE", R, STRING(checkpoint),
     "keep a checkpoint in this file, from which --resume goes on; the one before is FILE.old", NULL},
    {GROUP_OUTPUT, "--checkpoint-every", "SECONDS", R, TAKE(take_checkpoint_seconds),
     "time between checkpoints; 60 by default", NULL},
    {GROUP_OUTPUT, "--resume", "FILE", R, STRING(resume),
     "go on from a checkpoint of the same picture. It may be the file of --checkpoint: where there is none "
     "yet, the picture begins",
     NULL},

    {GROUP_SKY, "--sun", "EL[,AZ]", R | V | S | H | E | X, TAKE(take_sun),
     "the sun's elevation and azimuth (from +z toward +x), degrees", NULL},
    {GROUP_SKY, "--sun", "FROM..TO", W, STRING(sun_range),
     "the sun's elevation, or elevation and azimuth (EL,AZ..EL,AZ), in the first and the last frame, degrees",
     NULL},
    {GROUP_SKY, "--when", "FROM..TO", W, STRING(when),
     "with --where: the sun as it stands at these times in the first and the last frame", NULL},
    {GROUP_SKY, "--where", "LAT,LON[,M]", W, STRING(where), "where the sun of --when is seen", NULL},
    {GROUP_SKY, "--when", "TIME", R | V | I | S | H | E, STRING(when),
     "with --where: the sun as it stands at this time, such as 2026-06-21T20:30+02:00 (Z is UTC). Refraction "
     "is left "
     "out, as in pictures",
     NULL},
    {GROUP_SKY, "--where", "LAT,LON[,M]", R | V | I | S | H | E, STRING(where),
     "the place: degrees north, degrees east and metres of height. +z is north, or sun.north says where "
     "north is",
     NULL},
    {GROUP_SKY, "--sun-disk", "[=METHOD]", R | V | F | S | H | E | X, SWITCH(sun_disk),
     "show the sun's disk, 0.2666 degrees in radius: on, off or a method; on if it has no word; the scene's "
     "by "
     "default",
     NULL},
    {GROUP_SKY, "--atmosphere", "NAME", R | V | S | F | H | E | I | X, STRING(atmosphere),
     "a preset of the atmosphere (see info)", NULL},
    {GROUP_SKY, "--orders", "N", R | V | S | F | H | E | X, STRING(orders),
     "light that was scattered N times at most is seen, or `all`; short for --set atmosphere.orders=N", NULL},
    {GROUP_SKY, "--preset", "NAME", R | V | F | H | E | I | X, STRING(preset), "one of the scene's presets",
     NULL},
    {GROUP_SKY, "--set", "NAME=VALUE", R | V | S | F | I | H | E | X, TAKE(take_setting),
     "a scene's parameter, sun.elevation, atmosphere.mie_g, ...; may be repeated", NULL},

    {GROUP_ACCURACY, "--error", "PERCENT|Nlevels", R, TAKE(take_error),
     "stop when the estimated relRMSE is this (1), or the RMS in 8-bit levels of the picture as it is shown, "
     "with twice that in the worst 16x16 tile (2levels); 1 by default, unless --spp or --time is given. It "
     "is "
     "given up where it would take more than 2^20 samples of a pixel on average, or where 2^20 paths find no "
     "light. Exit status 7 if it cannot be promised",
     NULL},
    {GROUP_ACCURACY, "--error", "PERCENT|Nlevels", H, TAKE(take_error),
     "the error at which auto's choice is marked; 1 by default. With levels, the chart of paths is in levels",
     NULL},
    {GROUP_ACCURACY, "--error", "PERCENT", E, TAKE(take_percent),
     "a term that changes the picture by more is needed; 1 by default", NULL},
    {GROUP_ACCURACY, "--time", "SECONDS", R, TAKE(take_seconds),
     "stop after this time, with whole groups of samples", NULL},
    {GROUP_ACCURACY, "--time", "SECONDS", H, TAKE(take_seconds),
     "measure for about this time, without compilation; 150 by default", NULL},
    {GROUP_ACCURACY, "--spp", "N", R, TAKE(take_samples), "take this many samples of every pixel, up to 2^24",
     NULL},
    {GROUP_ACCURACY, "--spp", "N", V, TAKE(take_samples),
     "samples per pixel, after which the picture rests; a million by default", NULL},
    {GROUP_ACCURACY, "--first-sample", "K", R, TAKE(take_first_sample),
     "begin with sample K of every pixel (0 is the first): a part of a picture that other runs render too, "
     "for "
     "`merge`",
     NULL},
    {GROUP_ACCURACY, "--of", "N", R, TAKE(take_of),
     "for --first-sample: the samples of the whole picture, by which `auto` chooses as one run would", NULL},
    {GROUP_ACCURACY, "--seed", "N", R | V | X, TAKE(take_seed),
     "the seed of all random numbers; 0 by default", NULL},
    {GROUP_ACCURACY, "--depth", "N", R | V | H | E | X, TAKE(take_depth),
     "at most N surface hits; 0, the default, is unlimited", NULL},
    {GROUP_ACCURACY, "--max-relrmse", "PERCENT", C, TAKE(take_max_relrmse),
     "exit with 6 if the relRMSE is above this", NULL},
    {GROUP_ACCURACY, "--max-bias", "PERCENT", C, TAKE(take_max_bias),
     "exit with 6 if a channel's bias is beyond this", NULL},
    {GROUP_ACCURACY, "--max-levels", "N", C, TAKE(take_max_levels),
     "exit with 6 if the RMS difference of the shown pictures is above N levels of 255", NULL},
    {GROUP_ACCURACY, "--se", "FILE", C, STRING(standard_error),
     "standard errors of the difference: prints mean z^2 and the share of |z| > 4", NULL},

    {GROUP_METHODS, "--sky", "METHOD", R | V | F | S | X, STRING(sky), "how the sky's radiance is computed",
     NULL},
    {GROUP_METHODS, "--further", "METHOD", R | V | F | S | H | E | X, STRING(further),
     "how the orders of scattering beyond the first are computed", NULL},
    {GROUP_METHODS, "--light", "METHOD", R | V | F | X, STRING(light), "how paths continue after a hit",
     NULL},
    {GROUP_METHODS, "--sequence", "METHOD", R | V | F | X, STRING(sequence), "the random numbers", NULL},

    {GROUP_OTHER, "--kind", "KIND", N, WORD(kind, "exact,marched,shadertoy"),
     "exact (solids that rays meet by formulas), marched (a distance field) or shadertoy (a file with "
     "mainImage()); exact by default",
     NULL},
    {GROUP_OTHER, "--backend", "NAME", R | I | S | H | E, STRING(backend), "auto, egl, osmesa or glfw", NULL},
    {GROUP_OTHER, "--glsl-dir", "DIR", R | V | I | F | S | H | E | X, STRING(glsl_dir),
     "the GLSL library, in place of the one beside the program", NULL},
    {GROUP_OTHER, "--allow-includes", "DIR", R | V | I | F | H | E | X, TAKE(take_allowed),
     "let the scene read the files of this folder, besides those of its own and of the library; may be "
     "repeated",
     NULL},
    {GROUP_OTHER, "--max-memory", "SIZE", C, TAKE(take_max_memory),
     "the memory that all pictures together may take, such as 500M or 4G; by default each may take 256M and "
     "64 "
     "times its file",
     NULL},
    {GROUP_OTHER, "--max-memory", "SIZE", R | V | S | H | E, TAKE(take_max_memory),
     "refuse a picture that needs more memory than this, such as 500M or 4G", NULL},
    {GROUP_OTHER, "--compile-time", "SECONDS", R, TAKE(take_compile_seconds),
     "end if the driver takes longer than this processor time to compile one shader; 60 by default", NULL},
    {GROUP_OTHER, "--progress", "KIND", R | S | H | E, WORD(progress, "tty,lines,json,none"),
     "tty (a line that is written over), lines (one every 5 seconds), json or none; tty on a terminal, else "
     "lines",
     NULL},
    {GROUP_OTHER, "--progress", "KIND", V, WORD(progress, "json,none"),
     "json or none, for the window shows its progress; none by default", NULL},
    {GROUP_OTHER, "--quiet", NULL, C, FLAG(quiet), "print nothing: only the exit status", NULL},
    {GROUP_OTHER, "--quiet", NULL, R | S | H | E | M | W, FLAG(quiet), "no summary, no progress", NULL},
    {GROUP_OTHER, "-v", NULL, R, FLAG(verbose), "say what is chosen and why", NULL},
    {GROUP_OTHER, "-v", NULL, I, FLAG(verbose), "list all settings of the scene's atmosphere", NULL},
    {GROUP_OTHER, "-vv", NULL, R, FLAG(files), "the same, and the files that are compiled", NULL},
    {GROUP_OTHER, "-vv", NULL, E, FLAG(files), "list the library's files that are compiled, and that are not",
     NULL},
    {GROUP_OTHER, "--man", NULL, COMMAND_HELP, FLAG(manual), "all of this as a manual page", NULL},
    {GROUP_OTHER, "--completion", "SHELL", COMMAND_HELP, WORD(completion, "bash,zsh,fish"),
     "a script for this shell that completes commands, options and their words", NULL},
    {GROUP_OTHER, "--help", NULL, ALL, FLAG(help), "this text", "-h"},
    {GROUP_OTHER, "--version", NULL, ALL, FLAG(version), "the program's version", NULL},
};
const int option_table_size = sizeof option_table / sizeof *option_table;

static bool is_name(const char *name, const char *word, size_t length) {
    return name && strlen(name) == length && strncmp(name, word, length) == 0;
}

const OptionRow *option_find(const char *word, size_t length, Command command) {
    for (int i = 0; i < option_table_size; i++) {
        const OptionRow *row = &option_table[i];
        if (!(row->commands & (int)command)) continue;
        if (is_name(row->name, word, length) || is_name(row->alias, word, length)) return row;
    }
    return NULL;
}
