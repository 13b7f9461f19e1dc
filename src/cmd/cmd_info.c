#include "base/number.h"
#include "base/version.h"
#include "choice/method.h"
#include "cmd/cmd.h"
#include "cmd/info_file.h"
#include "cmd/info_sun.h"
#include "cmd/setup.h"
#include "gl/context.h"
#include "scene/scene_list.h"
#include "scene/sun_clock.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void print_backend(const Backend *backend) {
    Context context;
    Error error;
    if (!context_open(&context, backend->name, &error)) {
        printf("  %-8s refused: %s\n", backend->name, error.text);
        return;
    }
    printf("  %-8s %s, OpenGL %s, textures up to %d (%s)\n", backend->name, context.renderer, context.version,
           context.max_texture_size, context.detail);
    context_close(&context);
}

static void print_methods(void) {
    for (int family = 0; family < METHOD_FAMILIES; family++) {
        const MethodFamilyRow *row = method_family((MethodFamily)family);
        printf("%s (auto: %s)\n", row->option, row->automatic);
        for (int i = 0; method_get(i); i++) {
            const Method *method = method_get(i);
            if ((int)method->family != family) continue;
            printf("  %-8s %s%s%s\n", method->name, method->form ? method->form : "",
                   method->form ? ": " : "", method->about);
        }
    }
}

static void print_values(const double *values, int count) {
    for (int i = 0; i < count; i++) printf("%s%.9g", i ? "," : "", values[i]);
}

/* Prints all fields, or those alone in which the atmosphere is not like another. */
static void print_atmosphere(const Atmosphere *atmosphere, const Atmosphere *unlike) {
    for (int i = 0; atmosphere_field(i); i++) {
        const AtmosphereField *field = atmosphere_field(i);
        if (unlike && atmosphere_same(atmosphere, unlike, field)) continue;
        Text value = {0}, range = {0};
        atmosphere_print_value(atmosphere, field, &value);
        atmosphere_print_range(field, &range);
        printf("  atmosphere.%s = %s  (%s; %s)\n", field->name, text_string(&value), text_string(&range),
               field->description);
        text_free(&value);
        text_free(&range);
    }
}

/* Prints the hint as the file has it, and the current numbers where a word is a slider's name. */
static void print_hint(const Scene *scene, HintKind kind, int index) {
    const HintInfo *info = hint_info(kind);
    const Hint *hint = &scene->file->hints[kind].list[index];
    double now[MOST_HINT_NUMBERS], number;
    bool named = false;
    printf("  %s", info->key);
    for (int i = 0; i < info->components; i++) {
        printf(" %s", hint->words[i]);
        named |= !number_parse(hint->words[i], &number);
    }
    if (named) {
        scene_hint(scene, kind, index, now);
        printf("  = ");
        print_values(now, info->components);
    }
    printf("\n");
}

static void print_kind(const Scene *scene, HintKind kind) {
    const HintInfo *info = hint_info(kind);
    int count = scene_hint_count(scene, kind);
    if (scene->file->hints[kind].in_glsl) {
        printf("  %s: %d, by the scene's %s()\n", info->key, count, info->function);
        return;
    }
    for (int i = 0; i < count; i++) print_hint(scene, kind, i);
}

/* Prints the mist's words as the file has them, with what is taken where it says nothing. */
static void print_mist(const Scene *scene) {
    const Mist *mist = &scene->file->mist;
    if (!mist->line) return;
    Text text = {0};
    mist_describe(mist, &text);
    printf("  %s%s\n", text_string(&text), scene_has_mist(scene) ? "" : "  (off)");
    text_free(&text);
}

static void print_hints(const Scene *scene) {
    for (int kind = 0; kind < HINT_KINDS; kind++) print_kind(scene, (HintKind)kind);
    if (!scene->file->spheres[0]) return;
    int count = scene_sphere_count(scene);
    double number;
    printf("  spheres %s", scene->file->spheres);
    if (count >= 0 && !number_parse(scene->file->spheres, &number)) printf("  = %d", count);
    printf("\n");
}

/* The preset from which the atmosphere differs in the fewest fields. */
static const AtmospherePreset *nearest_preset(const Atmosphere *atmosphere, int *differing) {
    const AtmospherePreset *nearest = NULL;
    *differing = 0;
    for (int i = 0; atmosphere_preset(i); i++) {
        int count = 0;
        for (int k = 0; atmosphere_field(k); k++)
            count += !atmosphere_same(atmosphere, &atmosphere_preset(i)->atmosphere, atmosphere_field(k));
        if (nearest && count >= *differing) continue;
        nearest = atmosphere_preset(i);
        *differing = count;
    }
    return nearest;
}

static void print_air(const Atmosphere *atmosphere, bool whole) {
    int differing;
    const AtmospherePreset *preset = nearest_preset(atmosphere, &differing);
    printf("  atmosphere %s%s\n", preset->name,
           whole       ? ", with all its settings:"
           : differing ? ", except for (-v lists all):"
                       : " (-v lists its settings)");
    print_atmosphere(atmosphere, whole ? NULL : &preset->atmosphere);
}

static void print_camera(const Viewpoint *camera) {
    printf("  camera eye ");
    print_values(camera->eye, 3);
    printf(" target ");
    print_values(camera->target, 3);
    printf(" fov %g\n", camera->fov_deg);
}

static void print_scene(const Scene *scene, bool whole) {
    printf("%s: %s\n", scene->file->path, scene->file->title[0] ? scene->file->title : "untitled");
    if (scene->file->look[0]) printf("  look for: %s\n", scene->file->look);
    printf("  size %dx%d, sun elevation %g azimuth %g, exposure %g EV%s%s\n", scene->file->width,
           scene->file->height, scene->values.sun.elevation_deg, scene->values.sun.azimuth_deg,
           scene->values.exposure_ev, scene->file->sky[0] ? ", sky " : "", scene->file->sky);
    printf("  sun-disk %s, radius %g degrees\n", scene->values.sun_disk ? "on" : "off",
           scene->values.sun.radius_deg);
    print_camera(&scene->values.camera);
    print_hints(scene);
    print_mist(scene);
    if (scene->file->air_line) printf("  air %s\n", scene_has_air(scene) ? "on" : "off");
    for (int i = 0; i < scene->file->parameter_count; i++) {
        const Parameter *p = &scene->file->parameters[i];
        printf("  --set %s=", p->name);
        print_values(scene->values.parameters[i], p->type == PARAMETER_COLOR ? 3 : 1);
        printf("  (%g to %g%s%s; %s)\n", p->min, p->max, p->unit[0] ? " " : "", p->unit,
               p->label[0] ? p->label : "no label");
    }
    for (int i = 0; i < scene->file->preset_count; i++) {
        const Preset *preset = &scene->file->presets[i];
        printf("  --preset %s:", preset->name);
        for (int s = 0; s < preset->setting_count; s++) {
            printf(" %s=%s", preset->settings[s].name, preset->settings[s].value);
        }
        printf("\n");
    }
    print_air(&scene->values.atmosphere, whole);
}

static bool print_backends(const Options *options, Error *error) {
    bool all = !options->backend || strcmp(options->backend, "auto") == 0, found = false;
    printf("backends, in the order that auto tries\n");
    for (int i = 0; context_backend(i); i++) {
        const Backend *backend = context_backend(i);
        if (!all && strcmp(backend->name, options->backend) != 0) continue;
        print_backend(backend);
        found = true;
    }
    return found || error_set(error, STATUS_USAGE, "unknown backend '%s'", options->backend);
}

static bool info_scene(const Options *options, Error *error) {
    char *library = NULL;
    Scene scene = {0};
    bool ok = setup_library(options, &library, error) && setup_scene(options, library, &scene, error);
    if (ok) print_scene(&scene, options->verbose);
    if (ok && sun_clock_runs(&scene.values.clock)) info_print_sun(&scene.values.clock);
    scene_destroy(&scene);
    free(library);
    return ok;
}

/* The scenes that are found by name. */
static void print_scenes(const Options *options) {
    char *library;
    Error error;
    if (!setup_library(options, &library, &error)) {
        printf("scenes: none, because %s\n", error.text);
        return;
    }
    char *folder = scene_list_folder(library);
    SceneList list = scene_list_read(folder);
    printf("scenes, each found by its name from any folder; they are in %s%s\n", folder,
           list.count ? "" : ", where there is none");
    for (int i = 0; i < list.count; i++) printf("  %-12s %s\n", list.entries[i].name, list.entries[i].title);
    scene_list_free(&list);
    free(folder);
    free(library);
}

static bool info_program(const Options *options, Error *error) {
    Scene scene;
    if (!setup_scene(options, NULL, &scene, error)) return false;
    if (sun_clock_runs(&scene.values.clock)) {
        info_print_sun(&scene.values.clock);
        scene_destroy(&scene);
        return true;
    }
    printf("magichour %s\n", MAGICHOUR_VERSION);
    print_scenes(options);
    bool ok = print_backends(options, error);
    if (ok) {
        print_methods();
        printf("atmospheres\n");
        for (int i = 0; atmosphere_preset(i); i++)
            printf("  %-20s %s\n", atmosphere_preset(i)->name, atmosphere_preset(i)->source);
        printf("settings of the atmosphere, values of %s\n",
               options->atmosphere ? options->atmosphere : atmosphere_preset(0)->name);
        print_atmosphere(&scene.values.atmosphere, NULL);
    }
    scene_destroy(&scene);
    return ok;
}

Status cmd_info(const Options *options, Error *error) {
    const char *input = options->input_count ? options->inputs[0] : NULL;
    bool ok = !input                ? info_program(options, error)
              : info_is_file(input) ? info_print_file(input, error)
                                    : info_scene(options, error);
    return ok ? STATUS_DONE : error->status;
}
