#include "cmd/toy_options.h"

#include <string.h>

/* The first option that is about light, or NULL. */
static const char *useless_option(const Options *options) {
    const struct {
        bool given;
        const char *name;
    } all[] = {{options->error.amount > 0, "--error"},
               {options->seconds > 0, "--time"},
               {options->seed != 0, "--seed"},
               {options->depth != 0, "--depth"},
               {options->aov, "--aov"},
               {options->nan_map, "--nan-map"},
               {options->checkpoint, "--checkpoint"},
               {options->resume, "--resume"},
               {options->has_first_sample, "--first-sample"},
               {options->crop.width > 0, "--crop"},
               {options->has_sun, "--sun"},
               {options->sun_disk, "--sun-disk"},
               {options->atmosphere, "--atmosphere"},
               {options->orders, "--orders"},
               {options->sky, "--sky"},
               {options->further, "--further"},
               {options->light, "--light"},
               {options->sequence, "--sequence"},
               {options->has_exposure, "--exposure"},
               {options->samples && options->command == COMMAND_VIEW, "--spp"},
               {options->tone && strcmp(options->tone, "none") != 0, "--tone"}};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        if (all[i].given) return all[i].name;
    }
    return NULL;
}

/* Settings of what is not there. */
static const char *useless_setting(const Options *options) {
    static const char *const scenes[] = {"sun.", "camera.", "atmosphere.", "exposure="};
    for (int i = 0; i < options->setting_count; i++) {
        for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
            if (strncmp(options->settings[i], scenes[k], strlen(scenes[k])) == 0) return options->settings[i];
        }
    }
    return NULL;
}

bool toy_options_check(const Options *options, const SceneFile *file, Error *error) {
    const char *option = useless_option(options), *setting = useless_setting(options);
    if (!option && !setting) return true;
    return error_set(
        error, STATUS_USAGE,
        "%s%s: %s paints its picture by itself (mainImage() or main()), without sky, light and camera: "
        "leave it out; --size, --set time=SECONDS%s are for such files",
        option ? "" : "--set ", option ? option : setting, file->path,
        options->command == COMMAND_VIEW ? ", --record, --frames and --fps"
                                         : ", --set mouse=X,Y,Z,W, --frames and --spp");
}
