#include "cmd/setup.h"

#include "base/memory.h"
#include "base/text.h"
#include "cmd/scene_find.h"
#include "scene/sun_clock.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char landmark[] = "pass/trace.glsl";

static char *library_in(const char *folder, const char *name) {
    Text path = {0};
    text_print(&path, "%s/%s", folder, name);
    size_t length = path.size;
    text_print(&path, "/%s", landmark);
    if (access(text_string(&path), R_OK) != 0) {
        text_free(&path);
        return NULL;
    }
    path.data[length] = 0;
    return path.data;
}

bool setup_library(const Options *options, char **library, Error *error) {
    for (int i = 0; i < options->allowed_count; i++) {
        if (!source_folders_allow(options->allowed[i], error))
            return error_prefix(error, "--allow-includes ");
    }
    if (options->glsl_dir) {
        *library = library_in(options->glsl_dir, ".");
        free(*library);
        if (!*library) {
            return error_set(error, STATUS_USAGE, "--glsl-dir %s: no %s there", options->glsl_dir, landmark);
        }
        *library = memory_string(options->glsl_dir);
        return true;
    }
    char folder[4096];
    ssize_t length = readlink("/proc/self/exe", folder, sizeof folder - 1);
    folder[length > 0 ? length : 0] = 0;
    for (char *slash = strrchr(folder, '/'); slash; slash = strrchr(folder, '/')) {
        *slash = 0;
        *library = library_in(folder, "glsl");
        if (!*library) *library = library_in(folder, "share/magichour/glsl");
        if (*library) return true;
    }
    return error_set(error, STATUS_FAILURE,
                     "the GLSL library is not near the program; name it with --glsl-dir");
}

static bool apply_settings(const Options *options, Scene *scene, Error *error) {
    for (int i = 0; i < options->setting_count; i++) {
        const char *equals = strchr(options->settings[i], '=');
        char *name = memory_string_part(options->settings[i], (size_t)(equals - options->settings[i]));
        bool ok = scene_set(scene, name, equals + 1, error);
        free(name);
        if (!ok) return error_prefix(error, "--set ");
    }
    return true;
}

static bool read_scene(const char *word, const char *library, Scene *scene, Error *error) {
    char *path;
    if (!scene_find(word, library, &path, error)) return false;
    bool ok = scene_read(scene, path, library, error);
    free(path);
    return ok;
}

bool setup_scene(const Options *options, const char *library, Scene *scene, Error *error) {
    if (!options->input_count)
        *scene = scene_default("the sky", "");
    else if (!read_scene(options->inputs[0], library, scene, error))
        return false;
    if (options->preset && !scene_choose_preset(scene, options->preset, error)) goto fail;
    if (options->atmosphere && !atmosphere_choose(&scene->values.atmosphere, options->atmosphere, error))
        goto fail;
    const Sun *sun = &scene->values.sun;
    if (options->has_sun) scene_set_sun(scene, options->sun_elevation_deg, sun->azimuth_deg);
    if (options->has_azimuth) scene_set_sun(scene, sun->elevation_deg, options->sun_azimuth_deg);
    if ((options->where && !sun_clock_set_where(&scene->values, "--where", options->where, error)) ||
        (options->when && !sun_clock_set_when(&scene->values, "--when", options->when, error)))
        goto fail;
    if (options->where && !sun_clock_runs(&scene->values.clock)) {
        error_set(error, STATUS_USAGE, "--where says where the sun stands only together with --when");
        goto fail;
    }
    if (options->has_exposure) scene->values.exposure_ev = options->exposure_ev;
    if (options->orders && !atmosphere_set(&scene->values.atmosphere, "orders", options->orders, error)) {
        error_prefix(error, "--orders: ");
        goto fail;
    }
    if (!apply_settings(options, scene, error) || !scene_check(scene, error)) goto fail;
    return true;
fail:
    scene_destroy(scene);
    return false;
}

RenderParams setup_params(const Options *options, const Scene *scene) {
    return (RenderParams){.scene = scene,
                          .sky = options->sky,
                          .light = options->light,
                          .sequence = options->sequence,
                          .further = options->further,
                          .sun_disk = options->sun_disk,
                          .width = options->width,
                          .height = options->height,
                          .seed = options->seed,
                          .max_hits = options->depth};
}
