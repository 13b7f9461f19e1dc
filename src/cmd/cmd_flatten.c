#include "cmd/cmd.h"
#include "cmd/pass_json.h"
#include "cmd/setup.h"
#include "cmd/toy_options.h"
#include "scene/toy_source.h"

#include <stdio.h>
#include <stdlib.h>

/* Prints only the program that traces paths, as it is compiled. */
static bool print_trace(const Plan *plan, const RenderParams *params, Error *error) {
    GlslSource source = {0};
    bool ok = pass_text(paths_pass(plan), plan, params, &source, error);
    if (ok) fwrite(source.text.data, 1, source.text.size, stdout);
    glsl_source_destroy(&source);
    return ok;
}

/* Prints all programs in the order in which they are drawn, each after a line with its name. */
static bool print_all(const Plan *plan, const RenderParams *params, Error *error) {
    PassList list = pass_list(plan, params);
    for (int i = 0; i < list.count; i++) {
        GlslSource source = {0};
        if (!pass_text(&list.passes[i], plan, params, &source, error)) return false;
        printf("// ==== %s\n", list.passes[i].name);
        fwrite(source.text.data, 1, source.text.size, stdout);
        glsl_source_destroy(&source);
    }
    return true;
}

/* A file that paints its picture by itself is one program, as it is compiled (scene/toy_source.h). */
static bool print_toy(const Scene *scene, Error *error) {
    const ToyParams params = {.file = scene->file};
    GlslSource source;
    Text notes = {0};
    bool ok = toy_source_create(&source, &notes, &params, error);
    text_free(&notes);
    if (!ok) return false;
    fwrite(source.text.data, 1, source.text.size, stdout);
    glsl_source_destroy(&source);
    return true;
}

static bool print_scene(const Options *options, const RenderParams *params, Error *error) {
    Plan plan;
    return plan_make(&plan, params, NULL, error) &&
           (options->json  ? pass_json_print(&plan, params, stdout, error)
            : options->all ? print_all(&plan, params, error)
                           : print_trace(&plan, params, error));
}

Status cmd_flatten(const Options *options, Error *error) {
    char *library = NULL;
    Scene scene = {0};
    bool ok = setup_library(options, &library, error) && setup_scene(options, library, &scene, error);
    if (ok) {
        const RenderParams params = setup_params(options, &scene);
        ok = scene.file->facts.is_toy
                 ? toy_options_check(options, scene.file, error) && print_toy(&scene, error)
                 : print_scene(options, &params, error);
    }
    scene_destroy(&scene);
    free(library);
    return ok ? STATUS_DONE : error->status;
}
