#include "base/file.h"
#include "base/memory.h"
#include "cmd/cmd.h"
#include "cmd/setup.h"
#include "export/page.h"
#include "export/toy.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The command that renders the scene with the options that hold for all its presets. The scene has the name
 * that was typed: where it lies on this machine is nobody's business. */
static void write_command(const Options *options, Text *command) {
    text_print(command, "magichour render ");
    if (*options->inputs[0] == '-') text_print(command, "./");
    text_print_quoted(command, options->inputs[0]);
    if (options->atmosphere) text_print(command, " --atmosphere %s", options->atmosphere);
    if (options->orders) text_print(command, " --orders %s", options->orders);
    for (int i = 0; i < options->setting_count; i++) {
        text_print(command, " --set ");
        text_print_quoted(command, options->settings[i]);
    }
    if (!options->preset) return;
    text_print(command, " --preset ");
    text_print_quoted(command, options->preset);
}

/* Reads the scene once for the first state and once for each preset, whose sun is then the preset's own. */
static bool read_states(const Options *options, const char *library, PageState **states, int *count,
                        Error *error) {
    *states = memory_get(1, sizeof **states);
    **states = (PageState){.name = ""};
    if (!setup_scene(options, library, &(*states)->scene, error)) return false;
    const SceneFile *file = (*states)->scene.file;
    *states = memory_grow(*states, (size_t)file->preset_count + 1, sizeof **states);
    for (*count = 1; *count <= file->preset_count; ++*count) {
        Options other = *options;
        PageState *state = *states + *count;
        other.preset = file->presets[*count - 1].name;
        other.has_sun = false;
        other.when = other.where = NULL;
        *state = (PageState){.name = other.preset};
        if (!setup_scene(&other, library, &state->scene, error)) return false;
    }
    return true;
}

static bool write_page(const Options *options, const PageState *states, int count, Error *error) {
    Text html = {0}, command = {0};
    write_command(options, &command);
    const PageParams params = {.states = states,
                               .count = count,
                               .render = setup_params(options, &states[0].scene),
                               .command = text_string(&command)};
    bool ok = page_write(&params, &html, error);
    if (ok && strcmp(options->outputs[0], "-") == 0)
        fwrite(html.data, 1, html.size, stdout);
    else
        ok = ok && file_replace(options->outputs[0], html.data, html.size, error);
    text_free(&html);
    text_free(&command);
    return ok;
}

static bool export_page(const Options *options, const char *library, Error *error) {
    PageState *states = NULL;
    int count = 0;
    bool ok = (strcmp(options->outputs[0], "-") == 0 || file_check_target(options->outputs[0], error)) &&
              read_states(options, library, &states, &count, error) &&
              write_page(options, states, count, error);
    for (int i = 0; i < count; i++) scene_destroy(&states[i].scene);
    free(states);
    return ok;
}

/* The command is what the user typed. */
static bool export_toy(const Options *options, const char *library, int argc, char **argv, Error *error) {
    Scene scene;
    Text command = {0};
    if (!setup_scene(options, library, &scene, error)) return false;
    RenderParams params = setup_params(options, &scene);
    /* Whoever runs the texts chooses the size. */
    params.width = params.height = 0;
    text_print(&command, "magichour ");
    text_print_command(&command, argc - 1, argv + 1);
    bool ok = toy_export_write(&params, text_string(&command), options->outputs[0], error);
    text_free(&command);
    scene_destroy(&scene);
    return ok;
}

Status cmd_export(const Options *options, int argc, char **argv, Error *error) {
    char *library = NULL;
    if (options->output_count != 1) {
        error_set(error, STATUS_USAGE, "where to? (-o %s, once)", options->shadertoy ? "DIR" : "FILE.html");
        return error->status;
    }
    bool ok = setup_library(options, &library, error) &&
              (options->shadertoy ? export_toy(options, library, argc, argv, error)
                                  : export_page(options, library, error));
    free(library);
    return ok ? STATUS_DONE : error->status;
}
