#include "cmd/options_check.h"

#include "image/format.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

bool options_check(const Options *options, Error *error) {
    Command command = options->command;
    if (options->quiet && options->json)
        return error_set(error, STATUS_USAGE, "--quiet prints nothing, --json prints a line: one of them");
    if (options->quiet && (options->verbose || (options->files && command == COMMAND_RENDER)))
        return error_set(error, STATUS_USAGE, "--quiet says nothing, -v says more: one of them");
    if (command == COMMAND_RENDER && options->error.amount > 0 && options->samples)
        return error_set(error, STATUS_USAGE,
                         "--error takes as many samples as it needs, --spp takes so many: one of them");
    if (options->of && !options->has_first_sample)
        return error_set(error, STATUS_USAGE,
                         "--of: the samples of the whole, of a part that --first-sample begins");
    if (options->of && options->of < options->first_sample + options->samples)
        return error_set(error, STATUS_USAGE, "--of %llu: the part ends with sample %llu", options->of,
                         options->first_sample + options->samples - 1);
    if (options->has_sun && (options->when || options->where))
        return error_set(error, STATUS_USAGE,
                         "--sun says where the sun stands, and so do --when and --where: one of them");
    return true;
}

static void warn(bool given, const char *option, const char *why) {
    if (given) fprintf(stderr, "magichour: warning: %s has no effect: %s\n", option, why);
}

/* Whether one of the outputs goes through the tone curve. */
static bool shows(const Options *options) {
    if (options->format && options->output_count == 1) return strcmp(options->format, "png") == 0;
    for (int i = 0; i < options->output_count; i++) {
        const char *path = options->outputs[i], *dot = strrchr(path, '.');
        if (dot && strcasecmp(dot, ".png") == 0) return true;
        if (options->format && strcmp(options->format, "png") == 0 && !image_knows_ending(path)) return true;
    }
    return false;
}

static void warn_sky(const Options *options) {
    const char *rows = "with --at, the rows say it all", *shown = "no -o is a PNG";
    bool at = options->at != NULL, png = shows(options);
    warn(at && options->width, "--size", rows);
    warn(at && options->has_sun, "--sun", rows);
    warn(at && options->when, "--when", rows);
    warn(at && options->where, "--where", rows);
    warn(at && options->sun_disk, "--sun-disk", "--at writes the sky's radiances alone");
    warn(at ? options->has_exposure : options->has_exposure && !png, "--exposure", at ? rows : shown);
    warn(at ? options->tone != NULL : options->tone && !png, "--tone", at ? rows : shown);
    warn(at && options->quiet, "--quiet", "--at prints no summary");
}

/* Settings of what a map of the sky or a list of settings has not got. */
static void warn_no_scene(const Options *options) {
    static const char *const scenes[] = {"camera.", "time=", "mouse="};
    for (int i = 0; i < options->setting_count; i++) {
        for (int k = 0; k < 3; k++) {
            if (strncmp(options->settings[i], scenes[k], strlen(scenes[k])) != 0) continue;
            char words[128];
            snprintf(words, sizeof words, "--set %.100s", options->settings[i]);
            warn(true, words, "there is no scene");
        }
    }
}

void options_warn(const Options *options) {
    bool levels = options->error.amount > 0 && options->error.measure == NOISE_LEVELS;
    switch ((int)options->command) {
    case COMMAND_RENDER:
        warn(options->tone && !levels && !shows(options), "--tone",
             "no -o is a PNG, and --error is not in levels");
        break;
    case COMMAND_SKY:
        warn_sky(options);
        warn_no_scene(options);
        break;
    case COMMAND_VIEW:
        warn(options->frames && !options->record, "--frames", "nothing is recorded without --record");
        warn(options->frame_rate > 0 && !options->record, "--fps", "nothing is recorded without --record");
        break;
    case COMMAND_INFO:
        warn(options->backend && options->input_count, "--backend", "with a scene, info opens no backend");
        warn(options->glsl_dir && !options->input_count, "--glsl-dir", "there is no scene");
        if (!options->input_count) warn_no_scene(options);
        break;
    case COMMAND_EXPORT:
        warn(options->shadertoy && options->width, "--size",
             "a picture on Shadertoy has the size of its window");
        break;
    case COMMAND_FLATTEN:
        warn(options->all && options->json, "--all", "--json prints every program already");
        break;
    case COMMAND_COMPARE:
        warn(options->format && !options->output_count, "--format", "there is no -o");
        break;
    }
}
